// What the controls of a value are given.
import type { Field } from "../form/schema.ts";
import type { Place, Value } from "../protocol/messages.ts";

export interface Props {
  field: Field;
  place: Place;
  /** What the text holds; undefined where it holds nothing. */
  given: Value | undefined;
  /** What is in force. */
  value: Value | undefined;
  disabled?: boolean;
}

export type Held<T> = Props & { id: string; held: T };
