// sources sha256 2279b4d1f5c1fa60e744f4ce09d262d564fbd07121d87f8d06b2abdbb8a582c6
var Je,Uh,xc,Ni,_c,Da,Fh,La,Oh,yc,vc,Cm,yr=Symbol.for("pv"),Ua={},Fa=[],Rm=/^m(i|n|o|s|text|space)$/,bc=Array.isArray,Mc=Fa.slice,ss=Object.assign;function is(n){n&&n.parentNode&&n.remove()}function Bh(n,e,t){var i,s,r,a={},o=arguments.length;for(r in e)r=="key"?i=e[r]:r=="ref"&&typeof n!="function"?s=e[r]:a[r]=e[r];return o>2&&(a.children=o>3?Mc.call(arguments,2):t),xr(n,a,i,s,null)}function xr(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:yr,__v:s||++Uh,__i:-1,__u:0};return!s&&Je.vnode&&Je.vnode(r),r}function ft(n){return n.children}function Rs(n,e){this.props=n,this.context=e,this.__g=0}function Di(n,e){if(e==null)return n.__&&Di(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Di(n)}function Pm(n){var e,t=n.__v,i=t.__e,s=[],r=[],a=n.__P;a&&((e=ss({constructor:yr},t)).__v=t.__v+1,Je.vnode&&Je.vnode(e),Sc(a,e,t,n.__n,a.namespaceURI,32&t.__u?[i]:null,s,i||Di(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,Wh(s,e,r),t.__=t.__e=null,e.__e!=i&&kh(e))}function kh(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),kh(n)}function Nh(n){(8&n.__g||(n.__g|=8,Ni.push(n),Da++))&&_c==Je.debounceRendering||((_c=Je.debounceRendering)||queueMicrotask)(zh)}function zh(){try{for(var n,e=1;Ni.length;)Ni.length>e&&Ni.sort(Fh),n=Ni.shift(),e=Ni.length,8&n.__g&&Pm(n)}finally{(Da=Ni.length)&&(_c||queueMicrotask)(zh)}}function Vh(n,e,t,i,s,r,a,o,l,c,u){var m,d,h,_,x,p,f=i.__k||Fa,M=e.length;for(l=Im(t,e,f,l,M),m=0;m<M;m++)(h=t.__k[m])!=null&&(d=~h.__i&&f[h.__i]||Ua,h.__i=m,p=Sc(n,h,d,s,r,a,o,l,c,u),_=h.__e,(d.ref!=h.ref||8&d.__u)&&(d.ref&&wc(d.ref,null,h,d),h.ref&&u.push(h.ref,h.__c||_,h)),x=x||_,4&h.__u?(l=Gh(h,l,n,!d.__v),d.__e&&(d.__e=null)):typeof h.type=="function"&&p!==void 0?l=p:_&&(l=_.nextSibling),h.__u&=-21);return t.__e=x,l}function Im(n,e,t,i,s){var r,a,o,l,c,u,m,d,h,_=t.length,x=_,p=0,f=0,M=n.__k=Array(s);for(r=0;r<s;r++)(a=e[r])!=null&&typeof a!="boolean"&&typeof a!="function"?(typeof a!="object"||a.constructor===String?a=M[r]=xr(null,a):bc(a)?a=M[r]=xr(ft,{children:a}):a.constructor===yr&&a.__b?a=M[r]=xr(a.type,a.props,a.key,a.ref,a.__v):M[r]=a,l=r+p,a.__=n,a.__b=n.__b+1,o=null,~(c=a.__i=Lm(a,t,l,x))&&(x--,(o=t[c])&&(o.__u|=2)),o&&o.__v?(a.__u|=16,c==l-1?p--:c==l+1?p++:c!=l&&(c>l?p--:p++,f=1)):(~c||(s>_?p--:s<_&&p++),typeof a.type!="function"&&(a.__u|=4))):M[r]=null;if(f){for(u=[],m=[],r=0;r<s;r++)if((a=M[r])&&16&a.__u){for(p=0,d=u.length;p<d;)u[h=p+d>>1]<a.__i?p=h+1:d=h;u[p]=a.__i,m[r]=p+1}for(p=u.length;r--;)m[r]&&(m[r]==p?p--:M[r].__u|=4)}if(x)for(r=0;r<_;r++)!(o=t[r])||2&o.__u||(o.__e==i&&(i=Di(o)),Tc(o,o));return i}function Gh(n,e,t,i){var s,r,a,o;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=Gh(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=Di(n))&&!e.parentNode&&(e=null),a=n.__e,o=e;o&&o.nodeType==8;)o=o.nextSibling;for(a!=o&&(!i&&t.moveBefore&&a.parentNode?t.moveBefore(a,e):t.insertBefore(a,e||null)),e=a;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Lm(n,e,t,i){var s,r=n.key,a=n.type,o=e[t],l=o&&!(2&o.__u);if(o===null&&r==null||l&&r==o.key&&a==o.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((o=e[s])&&!(2&o.__u)&&r==o.key&&a==o.type)return s;for(s=t+1;s<e.length;s++)if((o=e[s])&&!(2&o.__u)&&r==o.key&&a==o.type)return s}return-1}function Dh(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Ia(n,e,t,i,s){var r,a;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Dh(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Dh(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(a=vc[e]||(vc[e]=Nm(e)),(n.__a||(n.__a={}))[e]=yc,r=e!=(e=e.replace(Oh,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,a,r):n.removeEventListener(e,a,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function Nm(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[La]==null)e[La]=yc++;else if(e[La]<this.__a[n])return;return t(Je.event?Je.event(e):e)}}}function Sc(n,e,t,i,s,r,a,o,l,c){var u,m,d,h,_,x,p,f,M,A,S,C,E,v,w,B,L,D,k=e.type;if(e.constructor!==yr)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,m=r=[],u.nodeType==8?o=Na(u,r):r.push(u),o=r[0]||o),(u=Je.__b)&&u(e);e:if(typeof k=="function"){d=a.length;try{if(f=e.props,M=(u=k.prototype)&&u.render,A=(u=k.contextType)&&i[u.__c],S=u?A?A.props.value:u.__:i,(h=t.__c)?(e.__c=h,2&h.__g&&(h.__g|=1)):(M?e.__c=h=new k(f,S):(e.__c=h=new Rs(f,S),h.constructor=k,h.render=Um),A&&A.sub(h),h.state||(h.state={}),h.__n=i,h.__g|=8,h.__h=[],h.__k=[]),M&&(h.__s||(h.__s=h.state),k.getDerivedStateFromProps&&(h.__s==h.state&&(h.__s=ss({},h.__s)),ss(h.__s,k.getDerivedStateFromProps(f,h.__s)))),_=h.props,x=h.state,h.__v=e,t.__c){if(f!==_&&M&&!k.getDerivedStateFromProps&&h.componentWillReceiveProps&&h.componentWillReceiveProps(f,S),e.__v==t.__v&&!(8&h.__g)||!(4&h.__g)&&h.shouldComponentUpdate&&h.shouldComponentUpdate(f,h.__s,S)===!1){e.__v!=t.__v&&(h.props=f,h.state=h.__s,h.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(H){H&&(H.__=e)}),Fa.push.apply(h.__h,h.__k),h.__k=[],h.__h.length&&a.push(h),o=Di(t);break e}h.componentWillUpdate&&h.componentWillUpdate(f,h.__s,S),M&&h.componentDidUpdate&&h.__h.push(function(){h.componentDidUpdate(_,x,p)})}else M&&!k.getDerivedStateFromProps&&h.componentWillMount&&h.componentWillMount(),M&&h.componentDidMount&&h.__h.push(h.componentDidMount);h.context=S,h.props=f,h.__P=n,h.__g&=-5,C=Je.__r,E=M?25:0;do h.__g&=-9,C&&C(e),u=h.render(h.props,h.state=h.__s,h.context);while(8&h.__g&&++E<25);M&&(Fa.push.apply(h.__h,h.__k),h.__k=[]),h.state=h.__s,h.getChildContext&&(i=ss({},i,h.getChildContext())),M&&t.__c&&h.getSnapshotBeforeUpdate&&(p=h.getSnapshotBeforeUpdate(_,x)),v=u&&u.type===ft&&u.key==null?u.props.children:u,f.__P&&(u=o,s=(n=f.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(H){H&&Tc(H,H)}),t.__k=null),o=t.__k?Di(t,0):null),o=Vh(n,bc(v)?v:[v],e,t,i,s,r,a,o,l,c),f.__P&&(e.__e=null,o=u),e.__u&=-161,m&&m.some(is),h.__h.length&&a.push(h),1&h.__g&&(h.__g&=-4)}catch(H){if(a.length=d,e.__v=null,l||r)if(H&&H.then){if(e.__u|=128|l,r){for(~(L=r.indexOf(o||void 0))||(L=r.length);(D=r[L-1])&&D.nodeType==8;)L--;for(;L<r.length;L++)if(D=r[L])if(r[L]=null,w){if(D==B)break}else{if(D.nodeType!=8)break;D.data.startsWith("$s")&&(B=Na(w=D))}}if(!w){for(;o&&o.nodeType==8&&o.nextSibling;)o=o.nextSibling;w=o}(u=Na(w=e.__c.__z||(e.__c.__z=w)))?(e.__e=w,o=u):e.__e=o,o=o&&o.nextSibling}else r&&r.some(is);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),H&&H.then||Hh(e),Je.__e(H,e,t)}}else o=e.__e=Dm(t.__e,e,t,i,s,r,a,l,c,n);return(u=Je.diffed)&&u(e),o}function Na(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function Hh(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(Hh))}function Wh(n,e,t){for(var i=0;i<t.length;)wc(t[i++],t[i++],t[i++]);Je.__c&&Je.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Je.__e(r,s.__v)}})}function Dm(n,e,t,i,s,r,a,o,l,c){var u,m,d,h,_,x,p,f,M=t.props||Ua,A=e.props,S=e.type;if(S=="svg"?s="http://www.w3.org/2000/svg":S=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((_=r[u])&&(S?_.localName==S:_.nodeType==3)){n=_,r[u]=null;break}}if(!n){if(f=c.ownerDocument||document,!S)return f.createTextNode(A);n=f.createElementNS(s,S,A.is?A:c),o&&(Je.__m&&Je.__m(e,r),o=!1),r=null}if(S){if(c=S=="template"&&n.content||n,r=S=="textarea"&&A.defaultValue!=null?null:r&&Mc.call(c.childNodes),!o&&r)for(M={},u=0;u<n.attributes.length;u++)M[(_=n.attributes[u]).name]=_.value;for(u in M)_=M[u],u=="dangerouslySetInnerHTML"?d=_:u=="children"||u in A||u=="value"&&"defaultValue"in A||u=="checked"&&"defaultChecked"in A||Ia(n,u,null,_,s);for(u in A)_=A[u],u=="children"?h=_:u=="dangerouslySetInnerHTML"?m=_:u=="value"?x=_:u=="checked"?p=_:o&&typeof _!="function"||M[u]===_||Ia(n,u,_,M[u],s);m?(o||d&&(m.__html==d.__html||m.__html==n.innerHTML)||(n.innerHTML=m.__html),e.__k=[]):(d&&(n.textContent=""),(S=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Rm.test(S))&&(s="http://www.w3.org/1999/xhtml"),Vh(c,bc(h)?h:[h],e,t,i,s,r,a,r?r[0]:t.__k&&Di(t,0),o,l),r&&r.some(is)),o&&S!="textarea"||(u="value",S=="progress"&&x==null?n.removeAttribute(u):x==null||x===n[u]&&(S!="progress"||x)||Ia(n,u,x,M[u],s),u="checked",p!=null&&p!=n[u]&&Ia(n,u,p,M[u],s))}else M===A||o&&n.data==A||(n.data=A);return n}function wc(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Je.__e(s,t)}}function Tc(n,e,t){var i,s,r,a;if(Je.unmount&&Je.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||wc(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(o){Je.__e(o,e)}i.__P=i.__n=null}if(i=n.__k)for(a=0;a<i.length;a++)i[a]&&Tc(i[a],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=Na(i,r=[]))&&(i==n.__e&&r.some(is),is(s),is(i)),t||is(n.__e),n.__e=n.__c=n.__=null}function Um(n,e,t){return this.constructor(n,t)}function Xh(n,e){var t,i,s,r;Je.__&&Je.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=xr(ft,{children:[n]}),s=[],r=[],Sc(e,e.__k,i||Ua,Ua,e.namespaceURI,i?null:e.firstChild?Mc.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),Wh(s,e.__k,r),e.__k.props.children=null}Je={__e:function(n,e,t,i){for(var s,r,a;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((a=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),a=1),a&&8&s.__g)return void(s.__g|=2)}catch(o){n=o}}throw Da=0,n}},Uh=0,xc=function(n){return n!=null&&n.constructor===yr},Rs.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=ss({},this.state)),typeof n=="function"&&(n=n(ss({},t),this.props)),n&&(ss(t,n),this.__v&&(e&&this.__k.push(e),Nh(this)))},Rs.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Nh(this))},Rs.prototype.render=ft,Ni=[],Da=0,Fh=function(n,e){return n.__v.__b-e.__v.__b},La=Symbol(),Oh=/(PointerCapture)$|Capture$/i,yc=0,vc={},Cm=0;var Oa,cn,Ac,qh,Fm=Object.is,Ec=0,td=[],Cc=[],wt=Je,$h=wt.__b,Yh=wt.__r,Zh=wt.diffed,Jh=wt.__c,Kh=wt.unmount,Qh=wt.__;function nd(n,e){wt.__h&&wt.__h(cn,n,Ec||e),Ec=0;var t=cn.__H||(cn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function bt(n,e){var t=nd(Oa++,3);!wt.__s&&id(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,cn.__H.__h.push(t))}function yt(n){return Ec=5,Ba(function(){return{current:n}},[])}function Ba(n,e){var t=nd(Oa++,7);return id(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function Om(){var n;do{for(;n=Cc.shift();)try{br(n)}catch(t){wt.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=td.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(br),e.__h.some(Rc),e.__h=[]}catch(t){e.__h=[],wt.__e(t,n.__v)}}}while(Cc.length)}wt.__b=function(n){cn=null,$h&&$h(n)},wt.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Qh&&Qh(n,e)},wt.__r=function(n){Yh&&Yh(n),Oa=0;var e=(cn=n.__c).__H;e&&(Ac==cn?cn.__h=[]:(e.__h.some(br),e.__h.some(Rc),Oa=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Ac=cn},wt.diffed=function(n){Zh&&Zh(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&ed(td.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Ac=cn=null},wt.__c=function(n,e){e.some(function(t){try{t.__h.some(br),t.__h=t.__h.filter(function(i){return!i.__||Rc(i)})}catch(i){t.__h=[function(){throw i}]}}),Jh&&Jh(n,e)},wt.unmount=function(n){Kh&&Kh(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,ed(Cc.push(s))}else br(s)}catch(r){e=r}}),i.__H=void 0,e&&wt.__e(e,i.__v))};var jh=typeof requestAnimationFrame=="function";function Bm(n){var e,t=function(){clearTimeout(i),jh&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);jh&&(e=requestAnimationFrame(t))}function ed(n){n!=1&&qh==wt.requestAnimationFrame||((qh=wt.requestAnimationFrame)||Bm)(Om)}function br(n){var e=cn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),cn=e}function Rc(n){var e=cn;n.__c=n.__(),cn=e}function id(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!Fm(t,n[i])})}var km=Symbol.for("preact-signals");function Ga(){if(ui>1)ui--;else{var n,e=!1;for((function(){var s=za;for(za=void 0;s!==void 0;){var r=s.S;if(r.v===s.v)for(var a=r.t;a!==void 0;a=a.x)a.i===s.i&&(a.i=r.i);s=s.o}})();Sr!==void 0;){var t=Sr;for(Sr=void 0,ka++;t!==void 0;){var i=t.u;if(t.u=void 0,t.f&=-3,!(8&t.f)&&rd(t))try{t.c()}catch(s){e||(n=s,e=!0)}t=i}}if(ka=0,ui--,e)throw n}}function Ps(n){if(ui>0)return n();Pc=++zm,ui++;try{return n()}finally{Ga()}}var Mr,pt=void 0;function wr(n){var e=pt,t=Mr;pt=void 0,Mr=void 0;try{return n()}finally{pt=e,Mr=t}}var Sr=void 0,ui=0,ka=0,zm=0,Pc=0,za=void 0,Va=0;function sd(n){if(pt!==void 0){var e=n.n;if(e===void 0||e.t!==pt)return e={i:0,S:n,p:pt.s,n:void 0,t:pt,e:void 0,x:void 0,r:e},pt.s!==void 0&&(pt.s.n=e),pt.s=e,n.n=e,32&pt.f&&n.S(e),e;if(e.i===-1)return e.i=0,e.n!==void 0&&(e.n.p=e.p,e.p!==void 0&&(e.p.n=e.n),e.p=pt.s,e.n=void 0,pt.s.n=e,pt.s=e),e}}function Pt(n,e){this.v=n,this.i=0,this.n=void 0,this.t=void 0,this.l=0,this.W=e?.watched,this.Z=e?.unwatched,this.name=e?.name}Pt.prototype.brand=km;Pt.prototype.h=function(){return!0};Pt.prototype.S=function(n){var e=this,t=this.t;t!==n&&n.e===void 0&&(n.x=t,this.t=n,t!==void 0?t.e=n:wr(function(){var i;(i=e.W)==null||i.call(e)}))};Pt.prototype.U=function(n){var e=this;if(this.t!==void 0){var t=n.e,i=n.x;t!==void 0&&(t.x=i,n.e=void 0),i!==void 0&&(i.e=t,n.x=void 0),n===this.t&&(this.t=i,i===void 0&&wr(function(){var s;(s=e.Z)==null||s.call(e)}))}};Pt.prototype.subscribe=function(n){var e=this;return Fn(function(){var t=e.value;wr(function(){return n(t)})},{name:"sub"})};Pt.prototype.valueOf=function(){return this.value};Pt.prototype.toString=function(){return this.value+""};Pt.prototype.toJSON=function(){return this.value};Pt.prototype.peek=function(){var n=this;return wr(function(){return n.value})};Object.defineProperty(Pt.prototype,"value",{get:function(){var n=sd(this);return n!==void 0&&(n.i=this.i),this.v},set:function(n){if(n!==this.v){if(ka>100)throw new Error("Cycle detected");(function(t){ui!==0&&ka===0&&t.l!==Pc&&(t.l=Pc,za={S:t,v:t.v,i:t.i,o:za})})(this),this.v=n,this.i++,Va++,ui++;try{for(var e=this.t;e!==void 0;e=e.x)e.t.N()}finally{Ga()}}}});function Te(n,e){return new Pt(n,e)}function rd(n){for(var e=n.s;e!==void 0;e=e.n)if(e.S.i!==e.i||!e.S.h()||e.S.i!==e.i)return!0;return!1}function ad(n){for(var e=n.s;e!==void 0;e=e.n){var t=e.S.n;if(t!==void 0&&(e.r=t),e.S.n=e,e.i=-1,e.n===void 0){n.s=e;break}}}function od(n){for(var e=n.s,t=void 0;e!==void 0;){var i=e.p;e.i===-1?(e.S.U(e),i!==void 0&&(i.n=e.n),e.n!==void 0&&(e.n.p=i)):t=e,e.S.n=e.r,e.r!==void 0&&(e.r=void 0),e=i}n.s=t}function rs(n,e){Pt.call(this,void 0,e),this.x=n,this.s=void 0,this.g=Va-1,this.f=4}rs.prototype=new Pt;rs.prototype.h=function(){if(this.f&=-3,1&this.f)return!1;if((36&this.f)==32||(this.f&=-5,this.g===Va))return!0;if(this.g=Va,this.f|=1,this.i>0&&!rd(this))return this.f&=-2,!0;var n=pt;try{ad(this),pt=this;var e=this.x();(16&this.f||this.v!==e||this.i===0)&&(this.v=e,this.f&=-17,this.i++)}catch(t){this.v=t,this.f|=16,this.i++}return pt=n,od(this),this.f&=-2,!0};rs.prototype.S=function(n){if(this.t===void 0){this.f|=36;for(var e=this.s;e!==void 0;e=e.n)e.S.S(e)}Pt.prototype.S.call(this,n)};rs.prototype.U=function(n){if(this.t!==void 0&&(Pt.prototype.U.call(this,n),this.t===void 0)){this.f&=-33;for(var e=this.s;e!==void 0;e=e.n)e.S.U(e)}};rs.prototype.N=function(){if(!(2&this.f)){this.f|=6;for(var n=this.t;n!==void 0;n=n.x)n.t.N()}};Object.defineProperty(rs.prototype,"value",{get:function(){if(1&this.f)throw new Error("Cycle detected");var n=sd(this);if(this.h(),n!==void 0&&(n.i=this.i),16&this.f)throw this.v;return this.v}});function nn(n,e){return new rs(n,e)}function ld(n){var e=n.j;if(n.j=void 0,typeof e=="function"){ui++;var t=pt;pt=void 0;try{e()}catch(i){throw n.f&=-2,n.f|=8,Ic(n),i}finally{pt=t,Ga()}}}function Ic(n){for(var e=n.s;e!==void 0;e=e.n)e.S.U(e);n.x=void 0,n.s=void 0,ld(n)}function Vm(n){if(pt!==this)throw new Error("Out-of-order effect");od(this),pt=n,this.f&=-2;try{8&this.f&&Ic(this)}finally{Ga()}}function Is(n,e){this.x=n,this.j=void 0,this.s=void 0,this.u=void 0,this.f=32,this.name=e?.name,Mr&&Mr.push(this)}Is.prototype.c=function(){var n=this.S();try{if(8&this.f||this.x===void 0)return;var e=this.x();typeof e=="function"&&(this.j=e)}finally{n()}};Is.prototype.S=function(){if(1&this.f)throw new Error("Cycle detected");this.f|=1,this.f&=-9,ld(this),ad(this),ui++;var n=pt;return pt=this,Vm.bind(this,n)};Is.prototype.N=function(){2&this.f||(this.f|=2,this.u=Sr,Sr=this)};Is.prototype.d=function(){this.f|=8,1&this.f||Ic(this)};Is.prototype.dispose=function(){this.d()};function Fn(n,e){var t=new Is(n,e);try{t.c()}catch(s){throw t.d(),s}var i=t.d.bind(t);return i[Symbol.dispose]=i,i}var cd,Wa,Ha,Gm=typeof window<"u"&&!!window.__PREACT_SIGNALS_DEVTOOLS__;var ud=[];Fn(function(){cd=this.N})();function Ls(n,e){Je[n]=e.bind(null,Je[n]||function(){})}function Tr(n){if(Ha){var e=Ha;Ha=void 0,e()}Ha=n&&n.S()}function hd(n){var e=this,t=n.data,i=sn(t);i.name="ReactiveDom",i.value=t;var s=Ba(function(){for(var o=e,l=e.__v;l=l.__;)if(l.__c){l.__c.__$f|=4;break}var c=nn(function(){var h=i.value.value;return h===0?0:h===!0?"":h||""}),u=nn(function(){return!Array.isArray(c.value)&&!xc(c.value)}),m=Fn(function(){if(this.N=dd,u.value){var h=c.value;o.__v&&o.__v.__e&&o.__v.__e.nodeType===3&&(o.__v.__e.data=h)}}),d=e.__$u.d;return e.__$u.d=function(){m(),d.call(this)},[u,c]},[]),r=s[0],a=s[1];return r.value?a.peek():a.value}hd.displayName="ReactiveTextNode";Object.defineProperties(Pt.prototype,{constructor:{configurable:!0,value:Bh(ft,null).constructor},type:{configurable:!0,value:hd},props:{configurable:!0,get:function(){var n=this;return{data:{get value(){return n.value}}}}},__b:{configurable:!0,value:1}});Ls("__b",function(n,e){if(Tr(),Wa=void 0,typeof e.type=="string"){var t,i=e.props;for(var s in i)if(s!=="children"){var r=i[s];r instanceof Pt&&(t||(e.__np=t={}),t[s]=r,i[s]=r.peek())}}n(e)});Ls("__r",function(n,e){if(n(e),e.type!==ft){Tr();var t,i=e.__c;i&&(i.__$f&=-2,(t=i.__$u)===void 0&&(i.__$u=t=(function(s,r){var a;return Fn(function(){a=this},{name:r}),a.c=s,a})((function(s){return function(){var r;Gm&&((r=this.y)==null||r.call(this)),s.__$f|=1,s.setState({})}})(i),typeof e.type=="function"?e.type.displayName||e.type.name:""))),Wa=i,Tr(t)}});Ls("__e",function(n,e,t,i){Tr(),Wa=void 0,n(e,t,i)});Ls("diffed",function(n,e){Tr(),Wa=void 0;var t;if(typeof e.type=="string"&&(t=e.__e)){var i=e.__np,s=e.props,r=t.U;if(r)for(var a in r){var o=r[a];o===void 0||i&&a in i||(o.d(),r[a]=void 0)}if(i){r||(r={},t.U=r);for(var l in i){var c=r[l],u=i[l];c===void 0?(c=Hm(t,l,u,s),r[l]=c):c.o(u,s)}}}n(e)});function Hm(n,e,t,i){var s=e in n&&n.ownerSVGElement===void 0,r=Te(t);return{o:function(a,o){r.value=a,i=o},d:Fn(function(){this.N=dd;var a=r.value.value;i[e]!==a&&(i[e]=a,s?n[e]=a:a!=null&&(a!==!1||e[4]==="-")?n.setAttribute(e,a):n.removeAttribute(e))})}}Ls("unmount",function(n,e){if(typeof e.type=="string"){var t=e.__e;if(t){var i=t.U;if(i){t.U=void 0;for(var s in i){var r=i[s];r&&r.d()}}}var a=e.__np;if(a){var o=e.props;for(var l in a)o[l]=a[l]}e.__np=void 0}else{var c=e.__c;if(c){c.__$f|=8;var u=c.__$u;u&&(c.__$u=void 0,u.d())}}n(e)});Ls("__h",function(n,e,t,i){i<3&&(e.__$f|=2),n(e,t,i)});Rs.prototype.shouldComponentUpdate=function(n,e){if(this.__R)return!0;var t=this.__$u,i=t&&t.s!==void 0;for(var s in e)return!0;if(this.__f||typeof this.u=="boolean"&&this.u===!0){var r=2&this.__$f;if(!(i||r||4&this.__$f)||1&this.__$f)return!0}else if(!(i||4&this.__$f)||3&this.__$f)return!0;for(var a in n)if(a!=="__source"&&n[a]!==this.props[a])return!0;for(var o in this.props)if(!(o in n))return!0;return!1};function sn(n,e){return Ba(function(){return Te(n,e)},[])}var Wm=function(n){queueMicrotask(function(){queueMicrotask(n)})};function Xm(){Ps(function(){for(var n;n=ud.shift();)cd.call(n)})}function dd(){ud.push(this)===1&&(Je.requestAnimationFrame||Wm)(Xm)}var Xa=class{constructor(e){this.send=e}send;busy=!1;waiting=new Map;push(e,t){this.waiting.set(e,t),this.busy||this.run()}async run(){for(this.busy=!0;;){let e=this.waiting.entries().next();if(e.done)break;let[t,i]=e.value;this.waiting.delete(t),await this.send(i)}this.busy=!1}};var mn=class extends Error{};function qm(n){if(n.byteLength<4)throw new mn("a frame is shorter than its length");let e=new DataView(n).getUint32(0,!0),t=Math.ceil((4+e)/8)*8;if(t>n.byteLength)throw new mn("a frame's header runs past its end");let i;try{i=JSON.parse(new TextDecoder().decode(new Uint8Array(n,4,e)))}catch{throw new mn("a frame's header is not JSON")}let{rows:s,cols:r,row0:a,band_rows:o}=i;if(![s,r,a,o].every(c=>Number.isInteger(c)&&c>=0)||s*r>67108864||a+o>s)throw new mn("a frame's band lies outside its layer");return{header:i,data:new Uint8Array(n,t)}}function md(n){let{header:e,data:t}=qm(n),i=e.band_rows*e.cols;switch(e.encoding){case"f32":return{header:e,samples:$m(t,i,e.nodata)};case"u16":return{header:e,samples:pd(fd(t,i),e)};case"u16_delta_deflate":return Zm(t,i*2).then(s=>{let r=fd(s,i);return Ym(r,e.band_rows,e.cols),{header:e,samples:pd(r,e)}});default:throw new mn(`encoding \`${String(e.encoding)}\` is not known`)}}function $m(n,e,t){if(n.byteLength<e*4)throw new mn("a frame has too few samples");let i=new Float32Array(n.slice(0,e*4).buffer);if(t!==null&&!Number.isNaN(t)){let s=Math.fround(t);for(let r=0;r<e;r++)i[r]===s&&(i[r]=NaN)}return i}function fd(n,e){if(n.byteLength<e*2)throw new mn("a frame has too few samples");return new Uint16Array(n.slice(0,e*2).buffer)}function pd(n,{offset:e,quantum:t}){let i=new Float32Array(n.length);for(let s=0;s<n.length;s++){let r=n[s];i[s]=r===65535?NaN:e+t*r}return i}function Ym(n,e,t){for(let i=0;i<e;i++){let s=i*t;i>0&&(n[s]=n[s]+n[s-t]);for(let r=1;r<t;r++)n[s+r]=n[s+r]+n[s+r-1]}}async function Zm(n,e){let t=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate")).getReader(),i=new Uint8Array(e),s=0;for(;;){let{done:r,value:a}=await t.read();if(r)break;if(s+a.length>e)throw await t.cancel(),new mn("a frame inflates to more than its band");i.set(a,s),s+=a.length}if(s<e)throw new mn("a frame has too few samples");return i}var qa=class{constructor(e,t){this.address=e;this.listener=t}address;listener;socket=null;next=1;waiting=new Map;tries=0;queue=Promise.resolve();open(){let e=new WebSocket(this.address);e.binaryType="arraybuffer",this.socket=e,e.onopen=()=>{this.tries=0,this.listener.connected(!0),this.ask({do:"hello",protocol:1})},e.onmessage=({data:t})=>{typeof t=="string"?this.hear(t):this.queue=this.queue.then(()=>this.take(t))},e.onclose=()=>{this.listener.connected(!1);for(let t of this.waiting.values())t({ok:!1,what:"the connection was lost",hint:null});this.waiting.clear(),window.setTimeout(()=>this.open(),Math.min(5e3,250*2**this.tries++))}}ask(e){let t=this.socket;if(!t||t.readyState!==WebSocket.OPEN)return Promise.resolve({ok:!1,what:"the studio is not connected",hint:null});let i=this.next++;return t.send(JSON.stringify({...e,request:i})),new Promise(s=>this.waiting.set(i,s))}hear(e){let t;try{t=JSON.parse(e)}catch{return this.listener.trouble("the server said something that is not JSON")}if(t.tell==="done"||t.tell==="refused"){let i=this.waiting.get(t.request);this.waiting.delete(t.request),i?.(t.tell==="done"?{ok:!0,text:t.text}:{ok:!1,what:t.what,hint:t.hint??null});return}this.listener.told(t)}async take(e){try{this.listener.frame(await md(e))}catch(t){this.listener.trouble(t instanceof mn?t.message:`a frame could not be read: ${String(t)}`)}}};var Jm={m:[1,1,0],mm:[.001,1,0],cm:[.01,1,0],km:[1e3,1,0],um:[1e-6,1,0],ft:[.3048,1,0],s:[1,0,1],min:[60,0,1],h:[3600,0,1],d:[86400,0,1],day:[86400,0,1],yr:[31557600,0,1],year:[31557600,0,1],years:[31557600,0,1],a:[31557600,0,1],kyr:[315576e5,0,1],ka:[315576e5,0,1],Myr:[315576e8,0,1],Ma:[315576e8,0,1],Gyr:[315576e11,0,1],Ga:[315576e11,0,1],deg:[Math.PI/180,0,0],"°":[Math.PI/180,0,0],rad:[1,0,0],"%":[.01,0,0],1:[1,0,0]};function gn(n){if(typeof n=="number")return Number.isFinite(n)?{number:n,unit:""}:null;if(typeof n!="string")return null;let e=/^\s*([+-]?(?:\d[\d_]*\.?[\d_]*|\.\d[\d_]*)(?:[eE][+-]?\d+)?)\s*(.*?)\s*$/.exec(n);if(!e)return null;let t=Number(e[1].replaceAll("_",""));return Number.isFinite(t)?{number:t,unit:e[2]}:null}function gd(n){let e=1,t=0,i=0,s=n.trim().split("/");for(let[r,a]of s.entries())for(let o of a.split(/[*·]/)){let l=/^\s*(1|[a-zA-Z°%]+)\s*(?:\^?(-?\d+))?\s*$/.exec(Km(o)),c=l&&Jm[l[1]];if(!l||!c)return null;let u=Number(l[2]??1)*(r===0?1:-1);e*=c[0]**u,t+=c[1]*u,i+=c[2]*u}return{si:e,length:t,time:i}}function Km(n){return n.replace("²","2").replace("³","3").replace("⁻¹","-1")}function as(n,e){if(n.unit===e||n.unit==="")return n.number;let t=gd(n.unit),i=gd(e);return!t||!i||t.length!==i.length||t.time!==i.time?null:n.number*t.si/i.si}function ke(n,e=4){if(n===0)return"0";if(!Number.isFinite(n))return String(n);let t=Number(n.toPrecision(e)),i=Math.abs(t);return i>=1e7||i<1e-4?t.toExponential().replace("e+","e"):String(t)}function Lc(n,e,t=4){let i=ke(n,t);return e===""?Number(i):`${i} ${e}`}function Nc(n){let e=Math.abs(n);if(e>=1e9)return`${ke(n/1e9,4)} Gyr`;if(e>=1e6)return`${ke(n/1e6,4)} Myr`;if(e>=1e4)return`${ke(n/1e3,4)} kyr`;if(e>=1||e===0)return`${ke(n,4)} yr`;let t=n*365.25;return t>=1?`${ke(t,3)} d`:`${ke(t*24,3)} h`}function $a(n){return n>=2**30?`${ke(n/2**30,3)} GiB`:n>=2**20?`${ke(n/2**20,3)} MiB`:n>=1024?`${ke(n/1024,3)} KiB`:`${n} B`}function Dc(n){return Math.abs(n)>=1e3?`${ke(n/1e3,4)} km`:`${ke(n,4)} m`}function os(n){return n>=1e5?`${ke(n/1e6,3)} km²`:`${ke(n,3)} m²`}var Qm=new Set(["use","label","from","with","clock","watch","process"]),Ns=class{constructor(e){this.schema=e}schema;stage(e,t=!1){let i=this.schema.$defs??{},s=(t?i[`process_${e}`]:void 0)??i[e];return s?this.fields(s,Qm):[]}clock(e){let t=this.schema.$defs?.[e]?.properties?.clock;return t?this.fields(this.resolve(t),new Set):[]}environment(){let e=this.schema.properties?.environment;return e?this.fields(this.resolve(e),new Set):[]}isProcess(e){return this.schema.$defs?.[`process_${e}`]!==void 0}help(e){return this.schema.$defs?.[e]?.description??""}fields(e,t){return Object.entries(e.properties??{}).filter(([i])=>!t.has(i)).map(([i,s])=>this.field(i,s))}field(e,t){let{inner:i,optional:s}=this.unwrap(t),r=this.kind(i),a={...i,...t};return{key:e,kind:r,varying:i["x-varying"]===!0,optional:s,help:(t.description??i.description??"").replaceAll(`
`," "),group:t["x-group"]??"main",default:t.default,least:a["x-min"]??a.minimum??a["x-above"]??null,most:a["x-max"]??a.maximum??a["x-below"]??null,slider:eg(t,i,r)}}resolve(e){return e.$ref?this.schema.$defs?.[e.$ref.split("/").at(-1)]??{}:e}unwrap(e){let t=this.resolve(e),i=t.anyOf?.filter(s=>s.type!=="null");return t.anyOf&&i&&i.length===t.anyOf.length-1&&i.length===1?{inner:this.resolve(i[0]),optional:!0}:{inner:t,optional:Ar(t).includes("null")}}kind(e){let t=this.choices(e);if(t)return{is:"choice",choices:t};if(e["x-varying"])return this.kind(this.resolve(e.anyOf?.[0]??{}));let i=Ar(e),s=e["x-unit"];return s!==void 0&&!i.includes("array")?jm(e,s):i.includes("number")?{is:"number",whole:!1}:i.includes("integer")?{is:"number",whole:!0}:i.includes("boolean")?{is:"switch"}:i.includes("string")?{is:"text"}:i.includes("array")?this.list(e):e.properties?{is:"group",fields:this.fields(e,new Set)}:{is:"any"}}list(e){let t=this.resolve(e.items??{}),i=this.choices(t);if(i)return{is:"choices",choices:i};let s=e.minItems!==void 0&&e.minItems===e.maxItems&&e.minItems<=4,r=t["x-unit"]!==void 0||Ar(t).some(a=>a==="number"||a==="integer");return!s||!r?{is:"any"}:{is:"list",count:e.minItems,unit:t["x-unit"]??"",bare:Ar(t).some(a=>a!=="string")}}choices(e){if(e.enum?.every(i=>typeof i=="string"))return e.enum.map(i=>({value:String(i),help:""}));let t=e.oneOf?.flatMap(i=>i.enum?.map(String)??(typeof i.const=="string"?[i.const]:[]));return!e.oneOf||!t||t.length<e.oneOf.length?null:e.oneOf.flatMap(i=>(i.enum?.map(String)??[String(i.const)]).map(s=>({value:s,help:i.description??""})))}};function Ar(n){return n.type===void 0?[]:Array.isArray(n.type)?n.type:[n.type]}function jm(n,e){return{is:"quantity",unit:e,example:n["x-example"]??"",bare:Ar(n).includes("number")}}function eg(n,e,t){if(t.is!=="quantity"&&t.is!=="number")return null;let i=n["x-soft-min"]??e["x-soft-min"],s=n["x-soft-max"]??e["x-soft-max"];if(i===void 0||s===void 0||!(s>i))return tg(n,t);let r=(n["x-scale"]??e["x-scale"])==="log"&&i>0;return{low:i,high:s,log:r}}function tg(n,e){if((e.is==="quantity"?e.unit:"")==="1/yr")return{low:1e-8,high:.001,log:!0};let i=n["x-min"]??n.minimum??n["x-above"],s=n["x-max"]??n.maximum??n["x-below"];return i!==void 0&&s!==void 0&&s>i&&s-i<=100?{low:i,high:s,log:!1}:null}var _d=["rock","granite","basalt","limestone","sandstone","shale","coral","clay","gravel","sediment","soil","sand","snow"],ng={sand:14267522,gravel:10257767,sediment:11901554,snow:15330803,sandstone:12880474,shale:9144960,limestone:14077882,granite:11774370,basalt:5657690,clay:10843226,coral:14471874,chalk:15131350,dolomite:13222058,marble:14210512,gneiss:11049875,quartzite:13480852,schist:8357756,slate:6712695,conglomerate:11111019,tuff:12562068},Ya=[12160879,9340279,12760474,7828335,10781546,10133647],ig=new Set(["sand","gravel","snow","coral","sediment"]);function vd(n){let e=n.filter(t=>!_d.includes(t)).sort();return[..._d,...e].map((t,i)=>{let s=ng[t]??Ya[i%Ya.length],r=t==="rock"||t==="soil"?0:ig.has(t)?1:.5;return{colour:[s>>16,s>>8&255,s&255],shows:r}})}function Uc(n){let e=Ya[Math.abs(n)%Ya.length];return{colour:[e>>16,e>>8&255,e&255],shows:.5}}var xd={height:["#3c6152","#5b7a59","#82915f","#b0a16d","#d2bb90","#ebdac3","#fcf7f0"],cividis:["#00224e","#1f3d6d","#4d566d","#73736e","#9b9274","#c9b66b","#fee838"],viridis:["#440154","#443a83","#31688e","#21908d","#35b779","#8fd744","#fde725"],depth:["#e6eef2","#9fc4dc","#5b95c2","#2d679f","#173f76","#0a1f47"],signed:["#2c4d8c","#6f93c4","#c3d2e3","#f2efe9","#e6c49a","#c08a4d","#7a4a1c"]};function sg(n){let e=parseInt(n.slice(1),16);return[e>>16&255,e>>8&255,e&255]}var yd=new Map;function ls(n){let e=yd.get(n);if(!e){let t=(xd[n]??xd.cividis).map(sg);e=new Uint8Array(768);for(let i=0;i<256;i++){let s=i/255*(t.length-1),r=Math.min(Math.floor(s),t.length-2);for(let a=0;a<3;a++)e[3*i+a]=Math.round(t[r][a]+(t[r+1][a]-t[r][a])*(s-r))}yd.set(n,e)}return e}function Za(n,e,t){if(n==="elevation")return{ramp:"height",log:!1,low:e,high:t};if(/area|discharge|flux/.test(n)&&t>0)return{ramp:"viridis",log:!0,low:Math.max(e,t*1e-6),high:t};if(/depth|water/.test(n))return{ramp:"depth",log:!1,low:Math.max(0,e),high:t};if(e<0&&t>0){let i=Math.max(-e,t);return{ramp:"signed",log:!1,low:-i,high:i}}return{ramp:n==="slope"?"cividis":"viridis",log:!1,low:e,high:t}}function Ja(n,{log:e,low:t,high:i}){if(!(i>t))return .5;let s=e?Math.log(Math.max(n,t)/t)/Math.log(i/t):(n-t)/(i-t);return Math.min(1,Math.max(0,s))}var Ka=class{picture=-1;parts=new Map;add({header:e,samples:t}){e.frame!==this.picture&&(this.picture=e.frame,this.parts=new Map);let{layer:i,rows:s,cols:r,row0:a,band_rows:o}=e,l=this.parts.get(i);if((!l||l.z.length!==s*r)&&(l={header:e,z:new Float32Array(s*r).fill(NaN),filled:0},this.parts.set(i,l)),l.z.set(t,a*r),l.filled+=o,!e.last)return null;let c=[...this.parts.values()].filter(u=>u.filled>=u.header.rows);return this.parts=new Map,c.map(({header:u,z:m})=>rg(u,m))}};function rg(n,e){let[t,i]=bd(e);return{layer:n.layer,rows:n.rows,cols:n.cols,cell:n.cell_size,origin:n.origin,z:e,min:t,max:i,time:n.time/31557600,level:n.level,revision:n.revision,stage:n.stage,sea:n.sea_level,stamp:n.stamp}}function bd(n){let e=1/0,t=-1/0;for(let i=0;i<n.length;i++){let s=n[i];s<e&&(e=s),s>t&&(t=s)}return e<=t?[e,t]:[0,0]}function vt(n){return[Math.max(1,n.cols-1)*n.cell[0],Math.max(1,n.rows-1)*n.cell[1]]}function Qa(n,e,t){return[e/n.cell[0]+(n.cols-1)/2,(n.rows-1)/2-t/n.cell[1]]}function Ui(n,e,t){if(!(e>=0&&t>=0&&e<=n.cols-1&&t<=n.rows-1))return NaN;let i=Math.min(Math.floor(e),Math.max(0,n.cols-2)),s=Math.min(Math.floor(t),Math.max(0,n.rows-2)),r=Math.min(i+1,n.cols-1),a=Math.min(s+1,n.rows-1),[o,l]=[e-i,t-s],c=n.z[s*n.cols+i]*(1-o)+n.z[s*n.cols+r]*o,u=n.z[a*n.cols+i]*(1-o)+n.z[a*n.cols+r]*o;return c*(1-l)+u*l}function ja(n,e,t){let i=Math.round(e),s=Math.round(t);return i>=0&&s>=0&&i<n.cols&&s<n.rows?n.z[s*n.cols+i]:NaN}function Md(n,e,t){let i=Math.min(Math.max(e,1),n.cols-2),s=Math.min(Math.max(t,1),n.rows-2),r=(Ui(n,i+1,s)-Ui(n,i-1,s))/(2*n.cell[0]),a=(Ui(n,i,s+1)-Ui(n,i,s-1))/(2*n.cell[1]);return Math.hypot(r,a)}function Sd(n){let e=new Float32Array(n.z.length);for(let s=0;s<n.rows;s++){let r=Math.max(0,s-1)*n.cols,a=Math.min(n.rows-1,s+1)*n.cols,o=(Math.min(n.rows-1,s+1)-Math.max(0,s-1))*n.cell[1]||1;for(let l=0;l<n.cols;l++){let c=Math.max(0,l-1),u=Math.min(n.cols-1,l+1),m=(n.z[s*n.cols+u]-n.z[s*n.cols+c])/((u-c)*n.cell[0]||1),d=(n.z[a+l]-n.z[r+l])/o;e[s*n.cols+l]=Math.atan(Math.hypot(m,d))*180/Math.PI}}let[t,i]=bd(e);return{...n,layer:"slope",z:e,min:t,max:i}}function wd(n,e){let t=e&&e.rows===n.rows&&e.cols===n.cols&&e.max>0,i=n.sea!==null&&n.min<n.sea?n.sea:null;if(!t&&i===null)return null;let s=new Float32Array(n.z.length).fill(-50);if(i!==null)for(let r=0;r<s.length;r++)s[r]=Math.max(-50,i-n.z[r]);return t&&ag(s,n,e),s}function ag(n,e,t){let{rows:i,cols:s,z:r}=e;for(let a=0;a<n.length;a++)t.z[a]>0&&(n[a]=Math.max(n[a],t.z[a]));for(let a=0;a<i;a++)for(let o=0;o<s;o++){let l=a*s+o;if(!(n[l]>0))for(let c=Math.max(0,a-1);c<=Math.min(i-1,a+1);c++)for(let u=Math.max(0,o-1);u<=Math.min(s-1,o+1);u++){let m=c*s+u,d=t.z[m];d>0&&(n[l]=Math.min(-.01,Math.max(n[l],r[m]+d-r[l])))}}}var Bn=Te(!1),_n=Te(null),Qe=Te(null),It=Te(null),eo=Te(null),Ds=Te([]),us=Te([]),hi=Te(new Ns({})),to=Te([]),no=Te(null),Fi=Te(null),hs=Te([]),cs=Te([]),Fc=Te(""),ds=Te(null),Cr=[],hn=Te(null),st=Te(null),Rr=Te(null),Tt=Te("land"),fs=Te(!1),Zt=Te("step"),On=Te("auto"),Yn=Te("elevation"),Pr=Te(!1),Ir=Te(!0),ps=Te(1),Us=Te(292),Fs=Te(30),kn=Te(0),io=Te(!0),di=Te(null),rt=Te(null),rn=Te(null),fi=Te(.06),zn=Te(.3),Lt=Te(null),Er=Te(new Map),pi=Te([]),un=Te(null),mi=Te(null),Zn=Te(null),kt=Te(null),Oi=Te(.5),Lr=Te(!1),Os=nn(()=>(Qe.value?.stages.length??0)>0||(Qe.value?.text.trim()??"")!==""),Nr=nn(()=>un.value===null?Er.value:pi.value[un.value]??Er.value),At=nn(()=>Nr.value.get("elevation")??null),Dr=nn(()=>Qe.value?.stages.some(n=>n.on&&(n.use==="dunes"||n.processes.some(e=>e.use==="dunes")))??!1),og=nn(()=>Object.keys(Qe.value?.given?.materials??{})),Ur=nn(()=>On.value!=="auto"?On.value:Dr.value?"sand":"natural"),Xt=nn(()=>{let n=At.value;if(!n)return null;let e=Nr.value,t=l=>{let c=e.get(l);return c&&c.rows===n.rows&&c.cols===n.cols?c:null},i=t("surface_material"),s=wd(n,io.value&&!Dr.value?t("lake_depth"):null),r=Yn.value,a=r==="slope"?t("slope")??Sd(n):t(r),o=Ur.value==="field"&&a;return{ground:n,depth:s,drainage:t("drainage_area"),material:i&&{raster:i,covers:vd(og.value)},field:o?{raster:a,scale:Za(r,a.min,a.max)}:null}}),Td=nn(()=>{let n=At.value;if(!n)return 2;let e=n.max-Math.max(n.min,n.sea??n.min);return e>1500?.74:e>800?.84:2});function vn(n,e){cs.value=[...cs.value.slice(-399),{kind:n,text:e,at:Date.now()}]}function Jt(n){Fc.value=n}var lg=192*2**20;function Ad(n){let e=n.get("elevation");if(!e)return;let t=pi.value,i=t.at(-1)?.get("elevation"),s=i&&i.level===e.level&&i.revision===e.revision,r=s&&e.time>i.time,a=s&&e.time===i.time,o=r?[...t,n]:a?[...t.slice(0,-1),n]:[n],l=e.z.byteLength*n.size,c=Math.max(8,Math.floor(lg/l));pi.value=o.length>c?o.filter((u,m)=>m%2===0||m===o.length-1):o,!r&&!a&&(un.value=null)}var cg=new Ka,ro,kc=[],zc=null,so=null,Fr=new Set;function Ed(){let n=location.protocol==="https:"?"wss":"ws";ro=new qa(`${n}://${location.host}/session`,{told:ug,frame:pg,connected(e){Bn.value=e,Vc="",e&&uo(),Jt(e?"Connected.":"The connection is lost; trying again.")},trouble:e=>vn("error",e)}),ro.open(),Bc("/schema.json",e=>hi.value=new Ns(e)),Bc("/stages.json",e=>us.value=e),Bc("/gallery.json",e=>to.value=e)}async function Bc(n,e){try{let t=await fetch(n);if(!t.ok)throw new Error(`${t.status}`);e(await t.json())}catch(t){vn("error",`${n} could not be read: ${String(t)}`)}}async function je(n){let e=await ro.ask(n);return e.ok||(vn("error",e.hint?`${e.what}. ${e.hint}`:e.what),Jt(`Refused: ${e.what}`)),e}function ug(n){Ps(()=>{switch(n.tell){case"welcome":_n.value=n;break;case"recipe":hg(n);break;case"state":fg(n);break;case"charts":eo.value=n;break;case"fields":Ds.value=n.names;break;case"log":vn(n.kind,n.text);break;case"latency":ds.value={server:n.sent-n.received,whole:ds.value?.whole??NaN};break;case"built":no.value=n,Fi.value=null,vn("note",`Built ${n.files.length} files in ${n.seconds.toFixed(1)} s.`),Jt("The build is done.");break;case"failed":Fi.value=n.hint?`${n.error}. ${n.hint}`:n.error,Jt(`The ${n.what} failed: ${n.error}`);break;case"contact":hs.value=hs.value.map(e=>e.seed===n.seed?{...e,picture:n.png}:e);break}})}function hg(n){let e=Qe.value,t=oo||e===null||e.path!==n.path||e.stages.length===0!=(n.stages.length===0);oo=!1,Qe.value=n;let i=hn.value,s=i?n.stages[i.stage]:void 0,r=i&&(!s||i.process!==null&&!s.processes[i.process]);(t||r)&&(hn.value=dg(n.stages)),t&&(pi.value=[],un.value=null,mi.value=Zn.value=null,kt.value=null,e!==null&&(Er.value=new Map),kn.value++,di.value=null),n.errors.length&&Jt(`The recipe has ${n.errors.length} mistakes: ${n.errors[0].what}`)}function dg(n){for(let[e,t]of n.entries()){let i=t.processes.findIndex(s=>Object.values(s.given).some(r=>gn(r)));if(t.on&&i>=0)return{stage:e,process:i}}return n.length?{stage:0,process:null}:null}function fg(n){let e=It.value;It.value=n,n.error&&n.error!==e?.error&&vn("error",n.error),(e?.running!==n.running||e.paused!==n.paused||e.level!==n.level)&&Jt(n.running?n.paused?"Paused.":`Running, level ${n.level??""}.`:"Ready.")}function pg(n){let e=cg.add(n);if(!n.header.last)return;if(kc.push(n.header.frame),!e?.length)return Cd();let{stamp:t}=n.header;if(t!==null&&Fr.delete(t)){zc=t,ao?.();for(let s of Fr)s<t&&Fr.delete(s)}let i=new Map(e.map(s=>[s.layer,s]));Ps(()=>{Er.value=i,Ad(i)})}function lo(){Cd(),so=zc,zc=null}function co(){if(so===null)return;let n=performance.now()-so;if(so=null,n<0||n>6e4)return;Cr.push(n),Cr.length>400&&Cr.shift(),ds.value={server:ds.value?.server??NaN,whole:n};let e=[...Cr].sort((i,s)=>i-s),t=e[Math.min(e.length-1,Math.ceil(e.length*.95)-1)];vn("latency",`event to drawn ${n.toFixed(0)} ms; 95 % of ${e.length} under ${t.toFixed(0)} ms`)}function Cd(){let n=kc;kc=[];for(let e of n)ro.ask({do:"ack",frame:e})}function mg(){let n=new Set(["elevation","drainage_area","lake_depth","surface_material"]),e=Yn.value;return On.value==="field"&&e!=="slope"&&n.add(e),[...n]}var Vc="";function uo(){let n=mg(),e=di.value,t=`${e} ${n.join(" ")}`;t!==Vc&&(Vc=t,je({do:"show",fields:n,stage:e}))}function Rd(n){di.value=n,uo()}var gg=600,ao=null,_g=new Xa(async n=>{!(await je(n)).ok||n.do!=="set"||!n.dragging||!Fr.has(n.stamp)||(await new Promise(t=>{let i=window.setTimeout(t,gg);ao=()=>{window.clearTimeout(i),t()}}),ao=null)});function Nt(n,e,t){t||ao?.();let i=performance.now();t&&Fr.add(i),_g.push(JSON.stringify(n),{do:"set",...n,value:e,dragging:t,stamp:i})}var oo=!1;function Pd(n){st.value=null,oo=!0,je({do:"open",gallery:n}).then(()=>oo=!1)}function Gc(){return crypto.getRandomValues(new Uint32Array(1))[0]%1e6}function Or(n){Nt({stage:null,process:null,key:["seed"]},n,!1)}function Hc(n){let e=Array.from({length:n},Gc);hs.value=e.map(t=>({seed:t,picture:null})),je({do:"contact",seeds:e})}function Br(n){let e=Xt.value;if(!e)return;let t=Qe.value?.seed??"?",i=`${n}: seed ${t}, level ${e.ground.level}`;(n==="A"?mi:Zn).value={name:i,state:e},Jt(`Kept as ${n}.`)}var vg=Symbol.for("pv"),xg=0;function g(n,e,t,i,s,r){e||(e={});var a,o,l=e;if("ref"in l&&typeof n!="function")for(o in l={},e)o=="ref"?a=e[o]:l[o]=e[o];var c={type:n,props:l,key:t,ref:a,__k:null,__:null,__b:0,__e:null,__c:null,constructor:vg,__v:--xg,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Je.vnode&&Je.vnode(c),c}var yg={undo:"M8 5 4 9l4 4M4.5 9H13a5 5 0 0 1 0 10h-3",redo:"m16 5 4 4-4 4M19.5 9H11a5 5 0 0 0 0 10h3",play:"M7 4.5v15l12-7.5z",pause:"M8 5v14M16 5v14",step:"M6 5v14l9-7zM18 5v14",stop:"M6 6h12v12H6z",plus:"M12 5v14M5 12h14",close:"m6 6 12 12M18 6 6 18",up:"m6 14 6-6 6 6",down:"m6 10 6 6 6-6",eye:"M2.5 12S6 5.5 12 5.5 21.5 12 21.5 12 18 18.5 12 18.5 2.5 12 2.5 12zM12 9.2a2.8 2.8 0 1 0 0 5.6 2.8 2.8 0 0 0 0-5.6z",trash:"M5 7h14M10 7V4.5h4V7M7 7l1 12.5h8L17 7M10.5 10.5v6M13.5 10.5v6",reset:"M5 5v5h5M5.5 10a7 7 0 1 1-.5 4",dice:"M5 5h14v14H5zM9 9h.01M15 15h.01M12 12h.01M15 9h.01M9 15h.01",home:"M4 11.5 12 5l8 6.5M6.5 10v9h11v-9",sun:"M12 8a4 4 0 1 0 0 8 4 4 0 0 0 0-8zM12 2.5v2M12 19.5v2M2.5 12h2M19.5 12h2M5.3 5.3l1.4 1.4M17.3 17.3l1.4 1.4M18.7 5.3l-1.4 1.4M6.7 17.3l-1.4 1.4",grid:"M4 4h6.5v6.5H4zM13.5 4H20v6.5h-6.5zM4 13.5h6.5V20H4zM13.5 13.5H20V20h-6.5z",folder:"M3.5 6.5h6l2 2.5h9v10h-17z",text:"M5 6h14M5 10h14M5 14h9M5 18h11",save:"M5 4.5h11l3.5 3.5v11.5H5zM8 4.5v5h7v-5M8 19.5v-6h8v6",copy:"M8.5 8.5h11v11h-11zM5 15.5V5h10.5",build:"M4 19.5h16M6 19.5 12 6l6 13.5M9.4 12h5.2",export:"M12 15V4M8 7.5 12 3.5l4 4M5 13v6.5h14V13",compare:"M12 3.5v17M4 6.5h5v11H4zM15 6.5h5v11h-5z",probe:"M12 3v6M12 15v6M3 12h6M15 12h6",orbit:"M12 7.5a4.5 4.5 0 1 0 0 9 4.5 4.5 0 0 0 0-9zM3 14.5c-2-4 5-8 11-8.5M21 9.500c2 4-5 8-11 8.500",raise:"M3.500 18.500h17M6 18.500c3.500 0 3.500-8 6-8s2.500 8 6 8M12 7.500v-5M9.500 5 12 2.500 14.500 5",lower:"M3.500 8.500H6c3.500 0 3.500 8 6 8s2.500-8 6-8h2.500M12 6.500v7",smooth:"M3.500 13c3-5 5.500-5 8.500 0s5.500 5 8.500 0M3.500 18.500h17",brush:"M19.500 4.500c-4.500 1.500-9 5.500-11 8.500l2.500 2.500c3-2 7-6.500 8.500-11zM8.500 13c-3 .3-2.500 3.500-5 5.500 3.500 1 7 .5 7.500-3",level:"M3.500 12h17M7 7.500v2M12 5.500v4M17 7.500v2M7 14.500v2M12 14.500v4M17 14.500v2",keys:"M3.500 7h17v10h-17zM7 10.500h.01M10.500 10.500h.01M14 10.500h.01M17 10.500h.01M8 14h8",help:"M9.300 9.300a2.700 2.700 0 1 1 3.900 2.400c-.9.500-1.200 1-1.200 2M12 17h.01",grip:"M9 6h.01M15 6h.01M9 12h.01M15 12h.01M9 18h.01M15 18h.01"};function Bs({name:n}){return g("svg",{class:"icon",viewBox:"0 0 24 24",width:"16",height:"16",fill:"none",stroke:"currentColor","stroke-width":"1.7","stroke-linecap":"round","stroke-linejoin":"round","aria-hidden":"true",children:g("path",{d:yg[n]??""})})}function Pe({icon:n,label:e,text:t,title:i,disabled:s,pressed:r,kind:a="plain",test:o,onClick:l}){return g("button",{type:"button",class:`button ${a}`,disabled:s,"aria-pressed":r,"data-testid":o,"aria-label":t?void 0:e,title:i??(t?void 0:e),onClick:l,children:[n&&g(Bs,{name:n}),t&&g("span",{children:e})]})}function Jn({title:n,wide:e,test:t,onClose:i,children:s}){let r=yt(null),a=yt(!1);return bt(()=>{let o=r.current;return o.open||o.showModal(),()=>{a.current=!0,o.close()}},[]),g("dialog",{ref:r,class:e?"modal wide":"modal","aria-label":n,"data-testid":t,onClose:()=>a.current||i(),onClick:o=>o.target===r.current&&r.current?.close(),children:[g("header",{class:"modal-head",children:[g("h2",{children:n}),g(Pe,{icon:"close",label:"Close",kind:"quiet",onClick:()=>r.current.close()})]}),g("div",{class:"modal-body",children:s})]})}function kr({label:n,value:e,choices:t,onChange:i}){return g("div",{class:"segments",role:"group","aria-label":n,children:t.map(s=>g("button",{type:"button","aria-pressed":s.value===e,"data-testid":`${n}-${s.value}`,onClick:()=>i(s.value),children:s.label},s.value))})}function ks({label:n,value:e,low:t,high:i,step:s,text:r,onInput:a}){return g("label",{class:"view-slider",children:[g("span",{children:n}),g("input",{type:"range",min:t,max:i,step:s,value:e,"aria-valuetext":r,style:{"--part":String((e-t)/(i-t))},onInput:o=>a(Number(o.currentTarget.value))}),g("output",{children:r})]})}var Id=10;function Ld(){return bt(()=>{hs.value.length===0&&Hc(Id)},[]),g(Jn,{title:"Seeds",wide:!0,test:"contact",onClose:()=>st.value=null,children:[g("p",{class:"dim lead",children:["The same recipe with other seeds. Click one to take it; the seed now is ",String(Qe.value?.seed??0),"."]}),g("ul",{class:"sheet",children:hs.value.map(({seed:n,picture:e})=>g("li",{children:g("button",{type:"button",class:"picture",disabled:!e,"data-testid":"contact-picture","aria-label":`Take seed ${n}`,onClick:()=>bg(n),children:[e?g(Mg,{data:e}):g("span",{class:"waiting",children:"growing…"}),g("span",{class:"picture-title",children:n})]})},n))}),g(Pe,{icon:"dice",label:"Other seeds",text:!0,test:"other-seeds",onClick:()=>Hc(Id)})]})}function bg(n){st.value=null,Or(n),Jt(`Seed ${n} is taken.`)}function Mg({data:n}){let e=yt(null);return bt(()=>{let t=Uint8Array.from(atob(n),i=>i.charCodeAt(0));createImageBitmap(new Blob([t],{type:"image/png"})).then(i=>{let s=e.current;s&&(s.width=i.width,s.height=i.height,s.getContext("2d").drawImage(i,0,0))})},[n]),g("canvas",{ref:e})}function qe(n){let e=n.replaceAll("_"," ");return e.charAt(0).toUpperCase()+e.slice(1)}function Nd(n){return n<.01?"< 10 ms":n<1?`${Math.round(n*1e3)} ms`:n<100?`${n.toFixed(1)} s`:`${Math.round(n/60)} min`}var Sg=[{name:"Unreal Engine",help:"16-bit PNG height map, with a card of the numbers to type",use:"write_heightmap",parameters:{preset:"unreal",path:"unreal.png"}},{name:"Unity",help:"16-bit RAW height map, with its card",use:"write_heightmap",parameters:{preset:"unity",path:"unity.raw"}},{name:"Godot",help:"Height map for Terrain3D (EXR), with its card",use:"write_heightmap",parameters:{preset:"godot",path:"godot.exr"}},{name:"Blender",help:"Height map for displacement (EXR)",use:"write_heightmap",parameters:{preset:"blender",path:"blender.exr"}},{name:"Mesh (GLB)",help:"For any program that reads glTF",use:"write_mesh",parameters:{path:"land.glb"}},{name:"GeoTIFF",help:"Elevations as numbers, for QGIS and other GIS",use:"write_raster",parameters:{field:"elevation",path:"elevation.tif"}},{name:"Weight maps",help:"Rock, soil, sand and snow as weights that sum to 255",use:"write_weights",parameters:{path:"weights.png"}},{name:"Contours",help:"Lines of equal height (GeoJSON)",use:"write_contours",parameters:{}},{name:"Report",help:"One page with pictures, charts and the report card (HTML)",use:"write_report",parameters:{path:"report.html"}}];function Dd(){let n=sn(null),e=It.value?.building||null,t=no.value?.files??[],i=async s=>{n.value=s.name,Fi.value=null;let r=await je({do:"export",use:s.use,parameters:s.parameters});n.value=null,r.ok||(Fi.value=r.hint?`${r.what}. ${r.hint}`:r.what)};return g(Jn,{title:"Export",wide:!0,test:"export",onClose:()=>st.value=null,children:[g("p",{class:"dim lead",children:["The land is first built at full size. Files go to ",g("b",{children:_n.value?.output??"the output folder"}),", and can be taken from here."]}),g("ul",{class:"forms",children:Sg.map(s=>g("li",{children:g("button",{type:"button",class:"form-card",disabled:n.value!==null||e?.what==="export","data-testid":`export-${s.name.split(" ")[0].toLowerCase()}`,onClick:()=>{i(s)},children:[g("b",{children:s.name}),g("small",{children:n.value===s.name?"writing…":s.help})]})},s.name))}),Fi.value&&g("p",{class:"fault",role:"alert",children:Fi.value}),e&&g("p",{class:"busy",role:"status",children:[e.name?qe(e.name):"Building"," at full size",e.part?`: ${Math.round(e.part*100)} %`:"…"]}),t.length>0&&g("section",{class:"files",children:[g("h3",{children:"Written"}),g("ul",{children:t.map(s=>g("li",{children:[g("a",{href:`/files?path=${encodeURIComponent(s.path)}`,download:s.path.split("/").at(-1),children:s.path})," ",g("small",{class:"dim",children:$a(s.bytes)})]},s.path))})]})]})}function Ud(){return g("main",{class:"welcome",children:[g("h1",{children:"Choose a landscape to begin with"}),g("p",{class:"dim",children:"Each is a recipe. It grows before your eyes; every value in it can be changed."}),g(Od,{})]})}function Fd(){return g(Jn,{title:"Open a landscape",wide:!0,test:"gallery",onClose:()=>st.value=null,children:g(Od,{})})}function Od(){return g("ul",{class:"pictures",children:to.value.map(n=>g("li",{children:g("button",{type:"button",class:"picture","data-testid":`open-${n.name}`,onClick:()=>Pd(n.name),children:[g("img",{src:n.picture,alt:"",width:"360",height:"240"}),g("span",{class:"picture-title",children:n.title}),g("span",{class:"picture-look",children:n.text??n.look})]})},n.name))})}var wg=40;function Bd(){let n=It.value,e=n?.running===!0&&!n.paused,t=pi.value.length,i=un.value??t-1,s=At.value?.time??0,r=(n?.running?n.part:n?.building?n.building.part:n?.part)??0;return g("section",{class:"time","aria-label":"Time","data-testid":"time",children:[g("div",{class:"time-buttons",children:[g(Pe,{icon:e?"pause":"play",label:e?"Pause":"Play",title:e?"Pause (P)":"Watch it grow (P)",kind:"strong",test:"play",onClick:Wc}),g(Pe,{icon:"step",label:"One step",title:"One step (.)",test:"step",disabled:e,onClick:()=>{je({do:"step"})}}),g(Pe,{icon:"stop",label:"Stop",test:"stop",disabled:!n?.running,onClick:()=>{je({do:"stop"})}})]}),g("output",{class:"clock","data-testid":"clock",children:Nc(s)}),g("div",{class:"scrub",children:[g("input",{type:"range",min:0,max:Math.max(1,t-1),step:1,value:Math.max(0,i),disabled:t<2,"aria-label":"Pictures of the past","aria-valuetext":Nc(s),style:{"--part":String(t>1?i/(t-1):0)},"data-testid":"scrub",onInput:a=>Ag(Number(a.currentTarget.value))}),g("div",{class:"progress",role:"progressbar","aria-label":"Progress","aria-valuemin":0,"aria-valuemax":100,"aria-valuenow":Math.round(r*100),children:g("i",{style:{width:`${Math.min(100,r*100)}%`},class:n?.running||n?.building?"on":""})})]}),g("div",{class:"time-facts",children:[un.value!==null&&g(Pe,{label:"To the newest",text:!0,kind:"quiet",onClick:()=>un.value=null}),g("span",{children:Tg()})]})]})}function Tg(){let n=It.value;if(!n)return"";let e=[];if(n.building){let{what:t,name:i,part:s}=n.building;e.push(`${t}${i?`: ${i.replaceAll("_"," ")}`:""}${s!=null?` ${Math.round(s*100)} %`:""}`)}return n.running&&n.name&&e.push(`${qe(n.name)}${n.of?` (${(n.stage??0)+1} of ${n.of})`:""}`),n.running&&n.steps&&e.push(`step ${n.steps}`),n.paused&&e.push("paused"),n.seconds_left!==null&&n.running?e.push(`${Math.max(1,Math.round(n.seconds_left))} s left`):n.seconds!==null&&n.seconds!==void 0&&!n.running&&e.push(`${n.seconds.toFixed(1)} s`),e.join(" · ")}function Ag(n){un.value=n>=pi.value.length-1?null:n}function Wc(){let n=It.value;un.value=null,je(n?.running&&!n.paused?{do:"pause"}:{do:"play",pace:wg})}function kd(){let n=Qe.value,e=Os.value,t=It.value?.building?It.value.building.what==="build":!1;return g("header",{class:"top",children:[g("div",{class:"brand",children:[g(Bs,{name:"build"}),g("span",{children:"landform"})]}),g(Pe,{icon:"folder",label:"Open",text:!0,test:"gallery-button",onClick:()=>st.value="gallery"}),e&&g(ft,{children:[g("h1",{class:"title",title:n?.path??void 0,children:[g("b",{children:n?.title??"Untitled"}),!n?.saved&&g("span",{class:"dim",children:" · not saved"})]}),g(Pe,{icon:"undo",label:"Undo",title:"Undo (Ctrl+Z)",kind:"quiet",disabled:!n?.can_undo,test:"undo",onClick:()=>{je({do:"undo"})}}),g(Pe,{icon:"redo",label:"Redo",title:"Redo (Ctrl+Shift+Z)",kind:"quiet",disabled:!n?.can_redo,test:"redo",onClick:()=>{je({do:"redo"})}}),g("span",{class:"space"}),g(Pe,{icon:"grid",label:"Seeds",text:!0,title:"Pictures of several seeds",test:"contact-button",onClick:()=>st.value="contact"}),g(Pe,{icon:"compare",label:"Compare",text:!0,test:"compare-button",pressed:kt.value!==null,onClick:Cg}),g(Pe,{icon:"text",label:"Text",text:!0,test:"text-button",pressed:Zt.value==="text",onClick:()=>Zt.value=Zt.value==="text"?"step":"text"}),g(Pe,{icon:"save",label:"Save",text:!0,title:"Save (Ctrl+S)",test:"save",disabled:n?.saved,onClick:()=>{Xc()}}),g(Pe,{icon:"copy",label:"Copy command",text:!0,title:n?.command,test:"copy",onClick:()=>{Eg(n?.command??"")}}),g(Pe,{icon:"export",label:"Export",text:!0,test:"export-button",onClick:()=>st.value="export"}),g(Pe,{icon:t?"stop":"build",label:t?"Cancel build":"Build",text:!0,kind:"strong",test:"build",disabled:(n?.errors.length??0)>0,title:"Runs the whole recipe at full size and writes its files",onClick:()=>{je({do:t?"cancel_build":"build"})}})]}),!e&&g("span",{class:"space"}),g(Pe,{icon:"keys",label:"Keys",kind:"quiet",onClick:()=>st.value="keys"}),g("span",{class:Bn.value?"dot on":"dot",role:"img","aria-label":Bn.value?"connected":"not connected",title:Bn.value?"Connected":"Not connected; trying again"})]})}async function Xc(){(await je({do:"save"})).ok&&Jt("Saved.")}async function Eg(n){try{await navigator.clipboard.writeText(n),vn("note",`Copied: ${n}`),Jt("The command is copied.")}catch{vn("note",n),Jt("The browser does not let the page copy; the command is in the log.")}}function Cg(){if(kt.value){kt.value=null;return}mi.value||Br("A"),kt.value="wipe"}var Rg=[["Ctrl+Z, Ctrl+Shift+Z","Undo, redo"],["Ctrl+S","Save"],["P","Play or pause"],[".","One step"],["1, 2, 3","3-D view, map, both"],["?","This list"],["Arrows on the view","Turn the view; on the map: move it"],["Shift+arrows","Move over the land"],["+ and −","Nearer, farther"],["Home","The whole land"],["Q, W, E, R, T on the view","Probe, raise, lower, smooth, level; Esc: none of them"],["Arrows, space with a tool","Move the brush (Shift: faster), paint"],["[ and ]","Brush smaller, larger"],[", and ;","Brush weaker, stronger"]];function zd(){return g(Jn,{title:"Keys",test:"keys",onClose:()=>st.value=null,children:[g("dl",{class:"keys",children:Rg.map(([n,e])=>g("div",{children:[g("dt",{children:n}),g("dd",{children:e})]},n))}),g("p",{class:"lead",children:g("a",{href:"/LICENSES.txt",target:"_blank",rel:"noopener",children:"Licences of the page's libraries"})})]})}function Vd(){bt(()=>{let n=e=>{let t=e.target,i=/^(INPUT|TEXTAREA|SELECT)$/.test(t.tagName)&&t.type!=="range"&&t.type!=="checkbox",s=e.ctrlKey||e.metaKey;if(!(!Os.value||st.value)){if(s&&e.key.toLowerCase()==="s")return gi(e,()=>{Xc()});if(s&&e.key.toLowerCase()==="z"&&t.tagName!=="TEXTAREA")return gi(e,()=>{je({do:e.shiftKey?"redo":"undo"})});i||s||e.altKey||(e.key==="p"?gi(e,Wc):e.key==="."?gi(e,()=>{je({do:"step"})}):e.key==="1"?gi(e,()=>Tt.value="land"):e.key==="2"?gi(e,()=>Tt.value="map"):e.key==="3"?gi(e,()=>Tt.value="both"):e.key==="?"?gi(e,()=>st.value="keys"):e.key==="Escape"&&rt.value&&gi(e,()=>rt.value=null))}};return window.addEventListener("keydown",n),()=>window.removeEventListener("keydown",n)},[])}function gi(n,e){n.preventDefault(),e()}function Gd(){let n=cs.value.findLast(s=>s.kind!=="latency"),e=It.value,t=ds.value,i=yt(null);return bt(()=>i.current?.scrollTo(0,i.current.scrollHeight),[cs.value,fs.value]),g("footer",{class:"log","data-testid":"log",children:[fs.value&&g("div",{ref:i,class:"log-lines",role:"log","aria-live":"off","aria-label":"Log",tabIndex:0,children:[cs.value.length===0&&g("p",{class:"dim",children:"Nothing has been noted yet."}),cs.value.slice(-200).map((s,r)=>g("p",{class:s.kind,children:[g("time",{children:new Date(s.at).toLocaleTimeString()})," ",s.text]},r))]}),g("div",{class:"log-strip",children:[g(Pe,{icon:fs.value?"down":"up",label:"Log",text:!0,kind:"quiet",test:"log-button",pressed:fs.value,onClick:()=>fs.value=!fs.value}),g("span",{class:`log-last ${n?.kind??""}`,children:n?.text??(Bn.value?"Ready.":"Connecting…")}),t&&Number.isFinite(t.whole)&&g("span",{title:"From the last event to its picture",children:[t.whole.toFixed(0)," ms to picture"]}),e?.memory_bytes?g("span",{title:"Memory of the server",children:$a(e.memory_bytes)}):null,g("span",{class:"dim",children:_n.value?.version?`landform ${_n.value.version}`:""})]})]})}function Wd(){let n=eo.value;return n?g("div",{class:"side-body","data-testid":"measures",tabIndex:0,role:"region","aria-label":"Measures",children:[g("h2",{children:"Measures"}),g("p",{class:"dim lead",children:["Of the ground at level ",n.level??"?","."]}),g(Pg,{c:n}),n.histogram&&n.histogram.counts.length>0&&g(Ng,{edges:n.histogram.edges,counts:n.histogram.counts}),n.hypsometry&&n.hypsometry.length>1&&g(Hd,{title:"Hypsometry",help:"Share of the land above a height",points:n.hypsometry,x:"share of the area",y:"height, m",line:!0}),n.slope_area&&n.slope_area.length>1&&g(Hd,{title:"Slope and area",help:"Rivers fall less the more land they drain",points:n.slope_area,x:"drainage area",y:"slope",log:!0}),n.card&&n.card.length>0&&g(Dg,{rows:n.card,verdict:n.verdict})]}):g("div",{class:"side-body",children:g("p",{class:"dim",children:"Measures come when a preview is done."})})}function Pg({c:n}){return g("dl",{class:"summary",children:Object.entries(n.summary).filter(([,e])=>e!==null).map(([e,t])=>g("div",{children:[g("dt",{children:qe(e)}),g("dd",{children:Lg(e,t)})]},e))})}var Ig=new Set(["min","max","mean","median","deviation","relief","sea_level"]);function Lg(n,e){return Ig.has(n)?`${ke(e,4)} m`:n==="area"?os(e):n==="mean_slope"?`${ke(e,3)}°`:n==="nodes"?e.toLocaleString("en"):ke(e,3)}var ho=312,ms=132,Bi=44,zs=26,zr=8,qc=10,Yc=ho-Bi-qc,$c=ms-zr-zs;function Xd({title:n,help:e,x:t,y:i,lowX:s,highX:r,lowY:a,highY:o,children:l}){return g("figure",{class:"chart",children:[g("figcaption",{children:[n," ",g("small",{class:"dim",children:e})]}),g("svg",{viewBox:`0 0 ${ho} ${ms}`,role:"img","aria-label":`${n}: ${t} from ${s} to ${r}, ${i} from ${a} to ${o}`,children:[g("path",{class:"axis",d:`M${Bi} ${zr}V${ms-zs}H${ho-qc}`}),l,g("text",{x:Bi-5,y:zr+8,"text-anchor":"end",children:o}),g("text",{x:Bi-5,y:ms-zs,"text-anchor":"end",children:a}),g("text",{x:Bi,y:ms-zs+13,children:s}),g("text",{x:ho-qc,y:ms-zs+13,"text-anchor":"end",children:r}),g("text",{x:Bi+Yc/2,y:ms-zs+13,"text-anchor":"middle",class:"axis-name",children:t})]})]})}function Ng({edges:n,counts:e}){let t=Math.max(...e,1),[i,s]=[n[0]??0,n.at(-1)??1],r=a=>Bi+Yc*(a-i)/(s-i||1);return g(Xd,{title:"Heights",help:"How much ground lies at each height",x:"height, m",y:"nodes",lowX:ke(i,3),highX:ke(s,4),lowY:"0",highY:"",children:e.map((a,o)=>{let[l,c]=[r(n[o]),r(n[o+1])],u=$c*a/t;return g("rect",{class:"bar",x:l+.5,y:zr+$c-u,width:Math.max(.5,c-l-1),height:u},o)})})}function Hd({title:n,help:e,points:t,x:i,y:s,line:r,log:a}){let o=t.filter(([f,M])=>Number.isFinite(f)&&Number.isFinite(M)&&(!a||f>0&&M>0));if(o.length<2)return null;let l=a?Math.log10:f=>f,c=f=>[Math.min(...o.map(M=>M[f])),Math.max(...o.map(M=>M[f]))],[u,m]=c(0),[d,h]=c(1),_=f=>Bi+Yc*(l(f)-l(u))/(l(m)-l(u)||1),x=f=>zr+$c*(1-(l(f)-l(d))/(l(h)-l(d)||1)),p=f=>a?os(f):ke(f,3);return g(Xd,{title:n,help:e,x:i,y:s,lowX:p(u),highX:p(m),lowY:ke(d,2),highY:ke(h,3),children:r?g("path",{class:"line",d:o.map(([f,M],A)=>`${A?"L":"M"}${_(f).toFixed(1)} ${x(M).toFixed(1)}`).join("")}):o.map(([f,M],A)=>g("circle",{class:"point",cx:_(f),cy:x(M),r:"2.2"},A))})}function Dg({rows:n,verdict:e}){return g("section",{class:"card",children:[g("h3",{children:"Report card"}),e&&g("p",{children:g("b",{children:e.title})}),e&&g("p",{class:"dim lead",children:e.reason}),g("p",{class:"dim lead",children:"Each number beside its range on real ground."}),g("ul",{children:n.map(t=>g("li",{title:t.meaning??void 0,children:[g("span",{children:qe(t.name)}),g("b",{children:[t.value===null?"–":ke(t.value,3),t.unit&&t.unit!=="1"?` ${t.unit}`:""]}),g("small",{class:"dim",children:t.low!==null&&t.high!==null?`${ke(t.low,3)} to ${ke(t.high,3)}`:""}),g("small",{class:`verdict ${t.verdict==="inside"?"good":""}`,children:t.verdict==="none"?"":t.verdict})]},t.name))})]})}function Kn({text:n}){return g(ft,{children:n.split("`").map((e,t)=>t%2?g("code",{children:e},t):e)})}function Vs({what:n,hint:e,line:t}){return g("p",{class:"fault",children:[t?`Line ${t}: `:"",g(Kn,{text:e?`${n}. ${e.charAt(0).toUpperCase()}${e.slice(1)}`:n})]})}var Ug=/(#.*$)|("(?:[^"\\]|\\.)*"|'[^']*')|([A-Za-z_][\w-]*(?=\s*=))|([+-]?\b\d[\d_]*(?:\.\d+)?(?:[eE][+-]?\d+)?\b|\b(?:true|false)\b)/g;function qd(n){return n.split(`
`).map(Fg)}function Fg(n){if(/^\s*\[.*\]\s*(#.*)?$/.test(n)&&!/=/.test(n.split("#")[0]))return[{text:n,kind:"head"}];let e=[],t=0;for(let i of n.matchAll(Ug)){i.index>t&&e.push({text:n.slice(t,i.index),kind:""});let s=i[1]?"comment":i[2]?"string":i[3]?"key":"number";e.push({text:i[0],kind:s}),t=i.index+i[0].length}return t<n.length&&e.push({text:n.slice(t),kind:""}),e}function $d(){let n=Qe.value,e=yt(null),t=yt(null),i=yt(null),s=sn(n?.text??""),r=yt(n?.text??""),a=yt(0);bt(()=>{n&&a.current===0&&n.text!==s.value&&(s.value=n.text,r.current=n.text)},[n?.revision,n?.text]),bt(()=>()=>{a.current&&(window.clearTimeout(a.current),o())},[]);let o=()=>{a.current=0,s.value!==r.current&&(r.current=s.value,je({do:"text",text:s.value}))},l=d=>{s.value=d,window.clearTimeout(a.current),a.current=window.setTimeout(o,350)},c=()=>{let{scrollTop:d,scrollLeft:h}=e.current;t.current.scrollTop=i.current.scrollTop=d,t.current.scrollLeft=h},u=new Map((n?.errors??[]).filter(d=>d.line!==null).map(d=>[d.line,d.what])),m=s.value.split(`
`);return g("div",{class:"editor","data-testid":"editor",children:[g("div",{class:"editor-box",children:[g("ol",{class:"gutter",ref:i,"aria-hidden":"true",children:m.map((d,h)=>g("li",{class:u.has(h+1)?"wrong":"",title:u.get(h+1),children:h+1},h))}),g("div",{class:"editor-text",children:[g("pre",{ref:t,"aria-hidden":"true",children:qd(s.value).map((d,h)=>g("div",{class:u.has(h+1)?"wrong":"",children:[d.map((_,x)=>_.kind?g("span",{class:`t-${_.kind}`,children:_.text},x):_.text),`
`]},h))}),g("textarea",{ref:e,"aria-label":"Text of the recipe",spellcheck:!1,autocomplete:"off",wrap:"off",value:s.value,"data-testid":"text",onInput:d=>l(d.currentTarget.value),onScroll:c,onBlur:()=>{a.current&&(window.clearTimeout(a.current),o())}})]})]}),g("div",{class:"editor-faults",role:"alert",children:(n?.errors??[]).map(d=>g("div",{class:"editor-fault",children:[d.line!==null&&g("button",{type:"button",class:"link",onClick:()=>Og(e.current,d.line,d.column??1),children:["Line ",d.line]}),g(Vs,{what:d.what,hint:d.hint})]},`${d.line} ${d.what}`))})]})}function Og(n,e,t){let i=n.value.split(`
`),s=i.slice(0,e-1).reduce((r,a)=>r+a.length+1,0)+t-1;n.focus(),n.setSelectionRange(s,s+Math.max(1,(i[e-1]?.length??0)-t+1)),n.scrollTop=Math.max(0,(e-6)*19)}function Yd(n,{low:e,high:t,log:i}){let s=i?Math.log(Math.max(n,e)/e)/Math.log(t/e):(n-e)/(t-e);return Math.min(1,Math.max(0,s))}function Zc(n,e,t=!1){let{low:i,high:s,log:r}=e,a=r?i*(s/i)**n:i+(s-i)*n;if(t)return Math.round(a);if(r)return Number(a.toPrecision(3));let o=10**Math.floor(Math.log10((s-i)/400));return Number((Math.round(a/o)*o).toPrecision(12))}function Zd(n,e){return e===null||!Number.isFinite(e)||n.log&&e<=0?n:{...n,low:Math.min(n.low,e),high:Math.max(n.high,e)}}function Gs(n){if(n===null)return"";if(typeof n=="string")return Jd(n);if(typeof n=="number"||typeof n=="boolean")return String(n);if(Array.isArray(n))return`[${n.map(Gs).join(", ")}]`;let e=Object.entries(n).map(([t,i])=>`${/^[A-Za-z0-9_-]+$/.test(t)?t:Jd(t)} = ${Gs(i)}`);return e.length?`{ ${e.join(", ")} }`:"{}"}function Jd(n){return JSON.stringify(n)}var Cn=class extends Error{};function fo(n){let e=new Jc(n),t=e.value(0);return e.end(),t}var Jc=class{constructor(e){this.text=e}text;at=0;value(e){if(e>32)throw new Cn("the value is nested too deeply");this.space();let t=this.text[this.at];if(t==='"'||t==="'")return this.string(t);if(t==="[")return this.array(e);if(t==="{")return this.table(e);let i=/^[^\s,\]}#]+/.exec(this.text.slice(this.at))?.[0];if(!i)throw new Cn("a value is missing");if(this.at+=i.length,i==="true"||i==="false")return i==="true";let s=i.replaceAll("_","");if(!/^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/.test(s))throw new Cn(`\`${i}\` is neither a number nor in quotes`);return Number(s)}end(){if(this.space(),this.at<this.text.length)throw new Cn(`\`${this.text.slice(this.at,this.at+12)}\` stands after the value`)}string(e){let i=(e==='"'?/^"(?:[^"\\\n]|\\.)*"/:/^'[^'\n]*'/).exec(this.text.slice(this.at))?.[0];if(!i)throw new Cn("a quotation mark is missing");if(this.at+=i.length,e==="'")return i.slice(1,-1);try{return JSON.parse(i)}catch{throw new Cn("a string has an unknown escape")}}array(e){let t=[];for(this.at++;;){if(this.take("]"))return t;if(t.push(this.value(e+1)),!this.take(",")&&!this.peek("]"))throw new Cn("`]` is missing")}}table(e){let t={};for(this.at++;;){if(this.take("}"))return t;let i=this.key();if(!this.take("="))throw new Cn(`\`=\` is missing after \`${i}\``);if(t[i]=this.value(e+1),!this.take(",")&&!this.peek("}"))throw new Cn("`}` is missing")}}key(){this.space();let e=this.text[this.at];if(e==='"'||e==="'")return this.string(e);let t=/^[A-Za-z0-9_-]+/.exec(this.text.slice(this.at))?.[0];if(!t)throw new Cn("a key is missing");return this.at+=t.length,t}space(){for(;/\s/.test(this.text[this.at]??"");)this.at++}peek(e){return this.space(),this.text[this.at]===e}take(e){return this.peek(e)?(this.at++,!0):!1}};function Hs({id:n,field:e,place:t,held:i,disabled:s}){let r=sn(""),a=i==null?"":Gs(i),o=l=>{try{let c=l.trim()===""?null:fo(l);r.value="",Nt(t,c,!1)}catch(c){r.value=c.message}};return g("div",{class:"inline",children:[g("textarea",{id:n,class:`field code ${r.value?"wrong":""}`,rows:Math.min(8,Math.max(1,Math.ceil(a.length/34))),spellcheck:!1,value:a,disabled:s,placeholder:e.optional?"none":"",onChange:l=>o(l.currentTarget.value)}),r.value&&g("p",{class:"fault",children:r.value})]})}function po({field:n,place:e,held:t,disabled:i}){if(!n.varying||n.kind.is!=="quantity"||e.stage===null||!_n.value?.can?.includes("stroke"))return null;let s=JSON.stringify(rn.value?.place)===JSON.stringify(e);return g(Pe,{icon:"brush",label:`Paint ${qe(n.key).toLowerCase()} onto the land`,kind:"quiet",pressed:s,disabled:i,test:`paint-${n.key}`,onClick:()=>Bg(n,e,t,s)})}function Bg(n,e,t,i){if(i){rn.value=null,rt.value=null;return}let s=n.kind.is==="quantity"?n.kind.unit:"",r=Qe.value?.stages[e.stage],a=e.process===null?r?.use:r?.processes[e.process]?.use;rn.value={place:e,label:`${qe(a??"")}: ${qe(n.key).toLowerCase()}`,unit:s==="1"?"":s,typical:kg(n,t,s)},rt.value="raise",Lt.value??=[0,0]}function kg(n,e,t){let i=e&&typeof e=="object"&&!Array.isArray(e)?e.base:e,s=n.kind.is==="quantity"?n.kind.example:"";for(let r of[i,n.default,s]){let a=gn(r),o=a&&as(a,t);if(o)return Math.abs(o)}return 1}function Kd(n){let{field:e,place:t,held:i,disabled:s}=n,r=i&&typeof i=="object"&&!Array.isArray(i)?i:null,a=r&&gn(r.base)?r.base:gn(e.default)?e.default:e.kind.is==="quantity"?e.kind.example:null;return g("div",{class:"varying",children:[g("div",{class:"varying-head",children:[g("span",{class:"dim",children:r?zg(r):"varies"}),g(po,{field:e,place:t,held:i,disabled:s}),e.kind.is==="quantity"&&g(Pe,{label:"Make it one number",text:!0,kind:"quiet",disabled:s,onClick:()=>Nt(t,a,!1)})]}),r&&Array.isArray(r.strokes)?g(Vg,{...n,table:r}):r&&typeof r.formula=="string"?g(Gg,{...n,table:r}):g(Hs,{...n})]})}function zg(n){return Array.isArray(n.strokes)?`painted: ${n.strokes.length} ${n.strokes.length===1?"stroke":"strokes"}`:"formula"in n?"by a formula of place":"times"in n?"changes in time":"amplitude"in n?"rises and falls in time":"image"in n||"raster"in n?"by a map":"feature"in n?"near what lies in the land":"field"in n?"by a field of the land":"varies"}function Vg({id:n,place:e,table:t,disabled:i}){let s=t.base;return g("label",{class:"view-slider strokes",children:[g("span",{children:"on a base of"}),g("input",{id:n,class:"field number",value:s==null?"":typeof s=="object"?"varies":String(s),disabled:i||typeof s=="object",spellcheck:!1,onChange:r=>gn(r.currentTarget.value)&&Nt({...e,key:[...e.key,"base"]},r.currentTarget.value.trim(),!1)})]})}function Gg({id:n,place:e,table:t,disabled:i}){let s=String(t.formula),r=typeof t.unit=="string"&&t.unit!=="1"?t.unit:"";return g(ft,{children:[g("textarea",{id:n,class:"field code",rows:Math.min(8,Math.max(2,Math.ceil(s.length/36))),spellcheck:!1,value:s,disabled:i,onChange:a=>Nt({...e,key:[...e.key,"formula"]},a.currentTarget.value,!1)}),g("small",{class:"dim",children:[r&&`in ${r}; `,"x, y: metres · u, v: 0 to 1 · r: from the middle"]})]})}function Vr(n){let{field:e,place:t,given:i,disabled:s}=n,r=sn(!1),a=`f-${t.stage}-${t.process}-${t.key.join("-")}`;return g("div",{class:`row ${i!==void 0?"given":""}`,"data-testid":`row-${t.key.join(".")}`,children:[g("div",{class:"row-head",children:[g("label",{for:a,title:e.help,children:qe(e.key)}),i!==void 0&&t.key.length>0&&g(Pe,{icon:"reset",label:`Back to default: ${qe(e.key)}`,kind:"quiet",disabled:s,onClick:()=>Nt(t,null,!1)}),g("button",{type:"button",class:"button quiet help-button","aria-expanded":r.value,"aria-label":`About ${qe(e.key)}`,onClick:()=>r.value=!r.value,children:"?"})]}),g(Wg,{...n,id:a}),r.value&&g("p",{class:"help",children:g(Kn,{text:`${e.help} ${Hg(e)}`})})]})}function Hg({least:n,most:e,default:t}){return[t!=null?`Default ${Gs(t)}.`:"",n!==null?`At least ${ke(n)}.`:"",e!==null?`At most ${ke(e)}.`:""].filter(Boolean).join(" ")}function Wg(n){let{field:e,given:t,value:i}=n,s=t!==void 0?t:i!==void 0?i:e.default,r=s==null||typeof s!="object";if(e.varying&&!r)return g(Kd,{...n,held:s});let{kind:a}=e;switch(a.is){case"quantity":case"number":return r?g(Xg,{...n,held:s}):g(Hs,{...n,held:s});case"switch":return g(Yg,{...n,on:s===!0});case"choice":return g(Zg,{...n,held:s,choices:a.choices.map(o=>o.value)});case"choices":return g(Jg,{...n,held:Array.isArray(s)?s.map(String):[],choices:a.choices.map(o=>o.value)});case"list":return Array.isArray(s)?g(Kg,{...n,held:s}):g(Hs,{...n,held:s});case"group":return g(Qg,{...n,fields:a.fields});case"text":return g(jg,{...n,held:typeof s=="string"?s:""});default:return g(Hs,{...n,held:s})}}function Xg({field:n,place:e,id:t,held:i,disabled:s}){let r=sn(null),a=sn(!1),o=n.kind.is==="quantity"?n.kind.unit:"",l=n.kind.is==="number"&&n.kind.whole,c=gn(i),u=c?.unit||(o==="1"?"":o),m=c?as(c,o):null,d=n.slider&&Zd(n.slider,m),h=A=>{if(n.kind.is==="number"||o==="1")return A;let S=c&&c.unit&&c.unit!==o?as({number:A,unit:o},c.unit):null;return S!==null?Lc(S,c.unit):Lc(A,o)},_=r.value!==null&&d?Zc(r.value,d,l):null,x=_!==null?Kc(h(_)):i==null?"":Kc(i),p=r.value??(d&&m!==null?Yd(m,d):0),f=(A,S)=>{d&&(r.value=S?A:null,Nt(e,h(Zc(A,d,l)),S))},M=A=>{let S=qg(A,n,u);a.value=S===void 0,S!==void 0&&Nt(e,S,!1)};return g("div",{class:"amount",children:[d&&g("input",{type:"range",min:0,max:400,step:1,value:Math.round(p*400),disabled:s,"aria-label":qe(n.key),"aria-valuetext":x||"none",class:m===null&&r.value===null?"none":"",style:{"--part":String(p)},"data-testid":`slider-${e.key.join(".")}`,onInput:A=>f(Number(A.currentTarget.value)/400,!0),onChange:A=>f(Number(A.currentTarget.value)/400,!1)}),g("input",{id:t,class:`field number ${a.value?"wrong":""}`,type:"text",inputMode:"decimal",spellcheck:!1,disabled:s,value:x,placeholder:n.optional?"none":"","aria-invalid":a.value,onChange:A=>M(A.currentTarget.value)}),g(po,{field:n,place:e,held:i,disabled:s}),n.varying&&g(Pe,{label:"ƒ",text:!0,kind:"quiet",title:"Let it vary: a formula of place",disabled:s,onClick:()=>Nt(e,$g(i,o),!1)})]})}function Kc(n){return typeof n=="number"?ke(n,6):String(n)}function qg(n,e,t){let i=n.trim();if(i===""||i==="none")return e.optional||e.default!==void 0?null:void 0;if(/^[{[]/.test(i))try{return fo(i)}catch{return}let s=gn(i);if(s)return e.kind.is==="number"||e.kind.is==="quantity"&&e.kind.unit==="1"?s.unit===""?s.number:void 0:s.unit===""?t?`${i} ${t}`:s.number:e.kind.is==="quantity"&&as(s,e.kind.unit)===null?void 0:i}function $g(n,e){let t=gn(n);return{formula:`${t?ke(as(t,e)??1):"1"}*(1 + 0.5*noise(x/3000, y/3000))`,unit:e}}function Yg({id:n,place:e,on:t,disabled:i}){return g("input",{id:n,type:"checkbox",class:"switch",checked:t,disabled:i,onChange:s=>Nt(e,s.currentTarget.checked,!1)})}function Zg({id:n,field:e,place:t,held:i,choices:s,disabled:r}){return g("select",{id:n,class:"field",value:i==null?"":String(i),disabled:r,onChange:a=>Nt(t,a.currentTarget.value||null,!1),children:[e.optional&&g("option",{value:"",children:"none"}),s.map(a=>g("option",{value:a,children:a.replaceAll("_"," ")},a))]})}function Jg({place:n,held:e,choices:t,disabled:i}){let s=r=>Nt(n,t.filter(a=>a===r?!e.includes(r):e.includes(a)),!1);return g("div",{class:"many",children:t.map(r=>g("label",{children:[g("input",{type:"checkbox",checked:e.includes(r),disabled:i,onChange:()=>s(r)}),r.replaceAll("_"," ")]},r))})}function Kg({id:n,field:e,place:t,held:i,disabled:s}){let r=sn(-1);if(e.kind.is!=="list")return null;let{unit:a}=e.kind,o=(l,c)=>{let u=gn(c);if(r.value=u?-1:l,!u)return;let m=a===""||a==="1"?u.number:u.unit===""?`${c.trim()} ${a}`:c.trim();Nt(t,i.map((d,h)=>h===l?m:d),!1)};return g("div",{class:"list",children:i.map((l,c)=>g("input",{id:c===0?n:void 0,class:`field number ${r.value===c?"wrong":""}`,value:Kc(l),disabled:s,"aria-label":`${qe(e.key)} ${c+1}`,spellcheck:!1,onChange:u=>o(c,u.currentTarget.value)},c))})}function Qg({place:n,given:e,value:t,field:i,fields:s,disabled:r}){let a=u=>u&&typeof u=="object"&&!Array.isArray(u)?u:{},o=a(i.default),[l,c]=[a(e),a(t)];return g("div",{class:"group",children:s.map(u=>g(Vr,{field:u,place:{...n,key:[...n.key,u.key]},given:l[u.key],value:c[u.key]??l[u.key]??o[u.key],disabled:r},u.key))})}function jg({id:n,place:e,held:t,disabled:i}){return g("input",{id:n,class:"field",type:"text",spellcheck:!1,value:t,disabled:i,onChange:s=>Nt(e,s.currentTarget.value||null,!1)})}var e0=[{value:"step",label:"Step"},{value:"recipe",label:"Recipe"},{value:"measures",label:"Measures"},{value:"text",label:"Text"}];function Qd(){return g("aside",{class:"side","aria-label":"Values","data-testid":"side",children:[g(kr,{label:"tab",value:Zt.value,choices:e0,onChange:n=>Zt.value=n}),Zt.value==="step"&&g(t0,{}),Zt.value==="recipe"&&g(o0,{}),Zt.value==="measures"&&g(Wd,{}),Zt.value==="text"&&g($d,{})]})}function t0(){let n=hn.value,e=n?Qe.value?.stages[n.stage]:void 0,t=e&&(n.process===null?e:e.processes[n.process]);if(!e||!t)return g("div",{class:"side-body",children:g("p",{class:"dim",children:"Choose a step at the left to see its values."})});let i=n.process!==null,s={stage:e.index,process:n.process,key:[]},r=us.value.find(o=>o.name===t.use),a=hi.value.stage(t.use,i);return g("div",{class:"side-body",children:[g("h2",{children:qe(t.use)}),g("p",{class:"dim lead",children:g(Kn,{text:r?.summary||hi.value.help(t.use)})}),g(n0,{stage:e.index}),!e.on&&g("p",{class:"step-note",children:"This step is off. Turn it on at the left to change it."}),!i&&g(a0,{stage:e,place:s}),g(s0,{fields:a,place:s,step:t,disabled:!e.on}),r&&r.sources.length>0&&g("details",{class:"sources",children:[g("summary",{children:"Sources"}),r.sources.map(o=>g("p",{class:"source",children:[o.authors,": ",o.title,o.doi?g(ft,{children:[" ",g("span",{class:"doi",children:o.doi})]}):null]},o.title))]})]},`${e.index} ${n.process}`)}function n0({stage:n}){let e=Qe.value?.errors.filter(t=>t.stage===n)??[];return g(ft,{children:e.map(t=>g(Vs,{what:t.what,hint:t.hint,line:t.line},t.what))})}var i0=new Set(["options","surroundings","files"]);function s0({fields:n,place:e,step:t,disabled:i}){let s=n.filter(o=>!i0.has(o.group)||t.given[o.key]!==void 0),r=n.filter(o=>!s.includes(o)),a=o=>g(Vr,{field:o,place:{...e,key:[o.key]},given:t.given[o.key],value:t.values[o.key],disabled:i},o.key);return g(ft,{children:[s.map(a),r.length>0&&g("details",{class:"more",children:[g("summary",{children:[s.length?"More":"Values"," (",r.length,")"]}),r.map(a)]})]})}var r0=new Set(["dt","duration","until"]);function a0({stage:n,place:e}){let t=hi.value.clock(n.use),i=n.given.clock??{},s=n.values.clock??i;if(!t.length)return null;let r=o=>g(Vr,{field:o,place:{...e,key:["clock",o.key]},given:i[o.key],value:s[o.key],disabled:!n.on},o.key),a=o=>r0.has(o.key)||i[o.key]!==void 0;return g("fieldset",{class:"clock-fields",children:[g("legend",{children:"Clock"}),t.filter(a).map(r),g("details",{class:"more",children:[g("summary",{children:"More of the clock"}),t.filter(o=>!a(o)).map(r)]})]})}function o0(){let n=Qe.value;if(!n)return null;let t=(n.given??{}).environment??{},i=s=>({stage:null,process:null,key:[s]});return g("div",{class:"side-body",children:[g("h2",{children:"Recipe"}),g("div",{class:"row",children:[g("div",{class:"row-head",children:g("label",{for:"recipe-title",children:"Title"})}),g("input",{id:"recipe-title",class:"field",value:n.title??"",onChange:s=>Nt(i("title"),s.currentTarget.value||null,!1)})]}),g("div",{class:"row",children:[g("div",{class:"row-head",children:g("label",{for:"recipe-seed",children:"Seed"})}),g("div",{class:"amount",children:[g("input",{id:"recipe-seed",class:"field number","data-testid":"seed",inputMode:"numeric",value:String(n.seed??0),onChange:s=>/^\d+$/.test(s.currentTarget.value.trim())&&Or(Number(s.currentTarget.value))}),g(Pe,{icon:"dice",label:"New seed",text:!0,test:"new-seed",onClick:()=>Or(Gc())})]})]}),g("h3",{children:"Environment"}),g("p",{class:"dim lead",children:"Sea, rain and wind, which all steps share."}),hi.value.environment().map(s=>g(Vr,{field:s,place:{stage:null,process:null,key:["environment",s.key]},given:t[s.key],value:t[s.key]},s.key))]})}function jd(){let n=sn(""),e=sn(null),t=Rr.value,i=n.value.trim().toLowerCase(),s=us.value.filter(a=>(t===null||c0(a.name))&&l0(a,i)),r=us.value.find(a=>a.name===e.value)??s[0];return g(Jn,{title:t===null?"Add a step":"Add a process",wide:!0,test:"add",onClose:()=>st.value=null,children:g("div",{class:"adder",children:[g("div",{class:"adder-list",children:[g("input",{type:"search",class:"field",placeholder:"Search: river, dunes, sea, mesh…","aria-label":"Search stages",autofocus:!0,value:n.value,onInput:a=>{n.value=a.currentTarget.value,e.value=null},onKeyDown:a=>a.key==="Enter"&&r&&Qc(r.name)}),g("ul",{children:s.map(a=>g("li",{children:g("button",{type:"button","aria-current":r?.name===a.name?"true":void 0,onClick:()=>e.value=a.name,onDblClick:()=>Qc(a.name),children:[g("b",{children:qe(a.name)}),g("small",{children:g(Kn,{text:a.summary})})]})},a.name))}),s.length===0&&g("p",{class:"dim",children:["No stage has “",n.value,"” in its name or text."]})]}),r&&g("div",{class:"adder-text",children:[g("h3",{children:[qe(r.name)," ",g("small",{class:"dim",children:r.folder})]}),g("p",{children:g(Kn,{text:r.text||r.summary})}),r.sources.length>0&&g("h4",{children:"Sources"}),r.sources.map(a=>g("p",{class:"source",children:[a.authors,": ",a.title,a.doi?`. ${a.doi}`:""]},a.title)),g("button",{type:"button",class:"button strong","data-testid":"add-this",onClick:()=>Qc(r.name),children:["Add ",qe(r.name).toLowerCase()]})]})]})})}function l0(n,e){return e===""||[n.name.replaceAll("_"," "),n.name,n.summary,n.folder,n.verb].some(t=>t?.toLowerCase().includes(e))}function c0(n){return hi.value.isProcess(n)}function Qc(n){let e=Rr.value,t=Qe.value?.stages.length??0,i=e===null?hn.value?hn.value.stage+1:t:Qe.value?.stages[e]?.processes.length??0;st.value=null,je({do:"insert",at:i,use:n,process_of:e}).then(s=>{s.ok&&(hn.value=e===null?{stage:i,process:null}:{stage:e,process:i})})}var Gr=Te(null),go=Te(null);function tf(){let n=Qe.value?.stages??[];return g("nav",{class:"steps","aria-label":"Steps","data-testid":"steps",children:[g("div",{class:"panel-head",children:[g("h2",{children:"Steps"}),g(Pe,{icon:"plus",label:"Add",text:!0,kind:"quiet",test:"add-step",onClick:()=>nf(null)})]}),g("ol",{class:"step-list",children:n.map(e=>g(u0,{stage:e,count:n.length},`${e.index} ${e.use}`))}),n.length===0&&g("p",{class:"dim pad",children:"The recipe has no steps yet."})]})}function nf(n){Rr.value=n,st.value="add"}function ef(n,e){hn.value={stage:n,process:e},Zt.value!=="text"&&(Zt.value="step")}function u0({stage:n,count:e}){let t=hn.value?.stage===n.index,i=Qe.value?.errors.filter(a=>a.stage===n.index)??[],s=It.value?.running&&It.value.stage===n.index,r=di.value===n.index;return g("li",{class:`step ${t?"chosen":""} ${n.on?"":"off"} ${s?"busy":""} ${go.value===n.index?"over":""}`,draggable:!0,onDragStart:a=>{Gr.value=n.index,a.dataTransfer?.setData("text/plain",n.use)},onDragOver:a=>{Gr.value!==null&&(a.preventDefault(),go.value=n.index)},onDragEnd:()=>Gr.value=go.value=null,onDrop:a=>{a.preventDefault(),h0(n.index)},children:[g("div",{class:"step-row",children:[g("span",{class:"grip",children:g(Bs,{name:"grip"})}),g("input",{type:"checkbox",class:"switch",checked:n.on,"aria-label":`${qe(n.use)} is on`,onChange:()=>{je({do:"toggle",stage:n.index})}}),g("button",{type:"button",class:"step-name","aria-current":t&&hn.value?.process===null?"true":void 0,"data-testid":`step-${n.index}`,onClick:()=>ef(n.index,null),children:[g("span",{children:qe(n.use)}),n.label&&g("small",{children:n.label})]}),n.seconds!==null&&n.seconds!==void 0&&g("small",{class:"cost",title:"Time that this step took last",children:Nd(n.seconds)}),g(Pe,{icon:"eye",label:r?"Look at the last step's ground":"Look at the ground after this step",kind:"quiet",pressed:r,onClick:()=>Rd(r?null:n.index)})]}),n.processes.length>0&&g("ul",{class:"processes",children:[n.processes.map((a,o)=>g("li",{class:"process-row",children:[g("button",{type:"button",class:"step-name","data-testid":`step-${n.index}-${o}`,"aria-current":t&&hn.value?.process===o?"true":void 0,onClick:()=>ef(n.index,o),children:g("span",{children:qe(a.use)})}),g(Pe,{icon:"trash",label:`Remove ${qe(a.use)}`,kind:"quiet",onClick:()=>{je({do:"remove",stage:n.index,process:o})}})]},`${o} ${a.use}`)),t&&n.use==="evolve"&&g("li",{children:g(Pe,{icon:"plus",label:"Add a process",text:!0,kind:"quiet",onClick:()=>nf(n.index)})})]}),i.map(a=>g(Vs,{what:a.what,hint:a.hint},a.what)),n.notes.map(a=>g("p",{class:"step-note",children:g(Kn,{text:a})},a)),t&&g("div",{class:"step-tools",children:[g(Pe,{icon:"up",label:"Move up",kind:"quiet",disabled:n.index===0,onClick:()=>{je({do:"move",stage:n.index,to:n.index-1})}}),g(Pe,{icon:"down",label:"Move down",kind:"quiet",disabled:n.index===e-1,onClick:()=>{je({do:"move",stage:n.index,to:n.index+1})}}),g(Pe,{icon:"trash",label:"Remove this step",kind:"quiet",onClick:()=>{je({do:"remove",stage:n.index,process:null})}}),n.nodes?g("small",{class:"dim",children:[n.nodes.toLocaleString("en")," nodes"]}):null]})]})}function h0(n){let e=Gr.value;Gr.value=go.value=null,e!==null&&e!==n&&je({do:"move",stage:e,to:n})}var d0=Math.PI/2-.001,_o=32*(Math.PI/180);function sf(n,e,t,i){let s={target:[0,0,t*.3],heading:-.4,pitch:.62,distance:1},r=Math.tan(_o/2)*.94,a=r*Math.max(i,.1),o=[-.5,.5].flatMap(l=>[-.5,.5].flatMap(c=>[-.06*Math.max(n,e),t].map(u=>[l*n,c*e,u])));for(let l=0;l<5;l++){let c=o.map(x=>f0(s,x));s.distance=Math.max(...c.map(([x,p,f])=>Math.max(Math.abs(x)/a,Math.abs(p)/r)-f));let u=x=>{let p=c.map(f=>f[x]/(s.distance+f[2]));return(Math.max(...p)+Math.min(...p))/2*s.distance},[m,d]=[u(0),u(1)],[h,_]=[Math.sin(s.heading),Math.cos(s.heading)];s.target[0]+=m*_+d*Math.sin(s.pitch)*h,s.target[1]+=-m*h+d*Math.sin(s.pitch)*_,s.target[2]+=d*Math.cos(s.pitch)}return s}function f0(n,e){let[t,i,s]=[e[0]-n.target[0],e[1]-n.target[1],e[2]-n.target[2]],[r,a,o,l]=[Math.sin(n.heading),Math.cos(n.heading),Math.sin(n.pitch),Math.cos(n.pitch)],c=t*r+i*a;return[t*a-i*r,c*o+s*l,c*l-s*o]}function rf({target:n,heading:e,pitch:t,distance:i}){let s=i*Math.cos(t);return[n[0]-s*Math.sin(e),n[1]-s*Math.cos(e),n[2]+i*Math.sin(t)]}function jc(n,e,t){let i=Math.min(d0,Math.max(.03,n.pitch+t)),s=2*Math.PI;return{...n,heading:((n.heading+e)%s+s)%s,pitch:i}}function vo(n,e,t){return{...n,distance:Math.min(t*6,Math.max(t*.004,n.distance*e))}}function eu(n,e,t,i){let[s,r]=[Math.sin(n.heading),Math.cos(n.heading)],a=n.distance,o=l=>Math.min(i,Math.max(-i,l));return{...n,target:[o(n.target[0]+a*(e*r+t*s)),o(n.target[1]+a*(-e*s+t*r)),n.target[2]]}}function af(n,e,t,i){let[s,r]=vt(n),a=(n.max-n.min)*e,[o,l]=m0(t,i,[-s/2,-r/2,-1e-6],[s/2,r/2,a+1e-6]);if(!(l>o))return null;let c=Math.max((l-o)/600,1e-9),u=o;for(let m=o;m<=l+c;m+=c){if(of(n,e,t,i,m)<=0)return p0(n,e,t,i,u,m);u=m}return null}function of(n,e,t,i,s){let[r,a]=Qa(n,t[0]+i[0]*s,t[1]+i[1]*s),o=Ui(n,Math.min(Math.max(r,0),n.cols-1),Math.min(Math.max(a,0),n.rows-1));return t[2]+i[2]*s-(o-n.min)*e}function p0(n,e,t,i,s,r){for(let a=0;a<12;a++){let o=(s+r)/2;of(n,e,t,i,o)<=0?r=o:s=o}return[t[0]+i[0]*r,t[1]+i[1]*r]}function m0(n,e,t,i){let s=0,r=1/0;for(let a=0;a<3;a++){if(Math.abs(e[a])<1e-12){if(n[a]<t[a]||n[a]>i[a])return[1,0];continue}let o=(t[a]-n[a])/e[a],l=(i[a]-n[a])/e[a];s=Math.max(s,Math.min(o,l)),r=Math.min(r,Math.max(o,l))}return[s,r]}var Rf=0,Cu=1,Pf=2;var ca=1,If=2,hr=3,Qi=0,on=1,Dn=2,Ss=0,dr=1,Ru=2,Pu=3,Iu=4,Lf=5;var ws=100,Nf=101,Df=102,Uf=103,Ff=104,Of=200,Bf=201,kf=202,zf=203,Lu=204,Nu=205,Vf=206,Gf=207,Hf=208,Wf=209,Xf=210,qf=211,$f=212,Yf=213,Zf=214,Vo=0,Go=1,Ho=2,sr=3,Wo=4,Xo=5,qo=6,$o=7,Du=0,Jf=1,Kf=2,si=0,Uu=1,Fu=2,Ou=3,Bu=4,ku=5,zu=6,Vu=7;var Gu=300,Ts=301,fr=302,_l=303,vl=304,Yo=1e3,Pn=1001,Zo=1002,Vt=1003,Qf=1004;var ua=1005;var mt=1006,xl=1007;var Ai=1008;var jt=1009,Hu=1010,Wu=1011,pr=1012,yl=1013,Xn=1014,Sn=1015,qn=1016,bl=1017,Ml=1018,As=1020,Xu=35902,qu=35899,$u=1021,Yu=1022,pn=1023,Si=1026,Ei=1027,Zu=1028,Sl=1029,ri=1030,wl=1031;var Tl=1033,ha=33776,da=33777,fa=33778,pa=33779,Al=35840,El=35841,Cl=35842,Rl=35843,Pl=36196,Il=37492,Ll=37496,Nl=37488,Dl=37489,ma=37490,Ul=37491,Fl=37808,Ol=37809,Bl=37810,kl=37811,zl=37812,Vl=37813,Gl=37814,Hl=37815,Wl=37816,Xl=37817,ql=37818,$l=37819,Yl=37820,Zl=37821,Jl=36492,Kl=36494,Ql=36495,jl=36283,ec=36284,ga=36285,tc=36286;var Yr=2300,Jo=2301,ko=2302,Mu=2303,Su=2400,wu=2401,Tu=2402;var jf=3200;var Ju=0,ep=1,Ci="",bn="srgb",Zr="srgb-linear",Jr="linear",tt="srgb";var zo=7680;var tp=519,np=512,ip=513,sp=514,Ku=515,rp=516,ap=517,Qu=518,ju=519,op=35044;var Ri="300 es",In=2e3,Kr=2001;function g0(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function _0(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Qr(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function lp(){let n=Qr("canvas");return n.style.display="block",n}var lf={},rr=null;function eh(...n){let e="THREE."+n.shift();rr?rr("log",e,...n):console.log(e,...n)}function cp(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ie(...n){n=cp(n);let e="THREE."+n.shift();if(rr)rr("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function Le(...n){n=cp(n);let e="THREE."+n.shift();if(rr)rr("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function $r(...n){let e=n.join(" ");e in lf||(lf[e]=!0,Ie(...n))}function up(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var hp={[Vo]:Vo,[Ho]:qo,[Wo]:Wo,[sr]:Xo,[Go]:Go,[qo]:Ho,[$o]:$o,[Xo]:sr},jn=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,e);e.target=null}}},Kt=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var tu=Math.PI/180,Ko=180/Math.PI;function _a(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Kt[n&255]+Kt[n>>8&255]+Kt[n>>16&255]+Kt[n>>24&255]+"-"+Kt[e&255]+Kt[e>>8&255]+"-"+Kt[e>>16&15|64]+Kt[e>>24&255]+"-"+Kt[t&63|128]+Kt[t>>8&255]+"-"+Kt[t>>16&255]+Kt[t>>24&255]+Kt[i&255]+Kt[i>>8&255]+Kt[i>>16&255]+Kt[i>>24&255]).toLowerCase()}function $e(n,e,t){return Math.max(e,Math.min(t,n))}function v0(n,e){return(n%e+e)%e}function nu(n,e,t){return(1-t)*n+t*e}function dp(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function th(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function x0(n,e){if(e.constructor===Float32Array)return n;let t=th(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function y0(n,e){if(e.constructor===Float32Array)return n;let t=th(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Ye=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=$e(this.x,e.x,t.x),this.y=$e(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=$e(this.x,e,t),this.y=$e(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar($e(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos($e(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,a=this.y-e.y;return this.x=r*i-a*s+e.x,this.y=r*s+a*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ei=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,a,o){let l=i[s+0],c=i[s+1],u=i[s+2],m=i[s+3],d=r[a+0],h=r[a+1],_=r[a+2],x=r[a+3];if(m!==x||l!==d||c!==h||u!==_){let p=l*d+c*h+u*_+m*x;p<0&&(d=-d,h=-h,_=-_,x=-x,p=-p);let f=1-o;if(p<.9995){let M=Math.acos(p),A=Math.sin(M);f=Math.sin(f*M)/A,o=Math.sin(o*M)/A,l=l*f+d*o,c=c*f+h*o,u=u*f+_*o,m=m*f+x*o}else{l=l*f+d*o,c=c*f+h*o,u=u*f+_*o,m=m*f+x*o;let M=1/Math.sqrt(l*l+c*c+u*u+m*m);l*=M,c*=M,u*=M,m*=M}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=m}static multiplyQuaternionsFlat(e,t,i,s,r,a){let o=i[s],l=i[s+1],c=i[s+2],u=i[s+3],m=r[a],d=r[a+1],h=r[a+2],_=r[a+3];return e[t]=o*_+u*m+l*h-c*d,e[t+1]=l*_+u*d+c*m-o*h,e[t+2]=c*_+u*h+o*d-l*m,e[t+3]=u*_-o*m-l*d-c*h,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,a=e._order,o=Math.cos,l=Math.sin,c=o(i/2),u=o(s/2),m=o(r/2),d=l(i/2),h=l(s/2),_=l(r/2);switch(a){case"XYZ":this._x=d*u*m+c*h*_,this._y=c*h*m-d*u*_,this._z=c*u*_+d*h*m,this._w=c*u*m-d*h*_;break;case"YXZ":this._x=d*u*m+c*h*_,this._y=c*h*m-d*u*_,this._z=c*u*_-d*h*m,this._w=c*u*m+d*h*_;break;case"ZXY":this._x=d*u*m-c*h*_,this._y=c*h*m+d*u*_,this._z=c*u*_+d*h*m,this._w=c*u*m-d*h*_;break;case"ZYX":this._x=d*u*m-c*h*_,this._y=c*h*m+d*u*_,this._z=c*u*_-d*h*m,this._w=c*u*m+d*h*_;break;case"YZX":this._x=d*u*m+c*h*_,this._y=c*h*m+d*u*_,this._z=c*u*_-d*h*m,this._w=c*u*m-d*h*_;break;case"XZY":this._x=d*u*m-c*h*_,this._y=c*h*m-d*u*_,this._z=c*u*_+d*h*m,this._w=c*u*m+d*h*_;break;default:Ie("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],a=t[1],o=t[5],l=t[9],c=t[2],u=t[6],m=t[10],d=i+o+m;if(d>0){let h=.5/Math.sqrt(d+1);this._w=.25/h,this._x=(u-l)*h,this._y=(r-c)*h,this._z=(a-s)*h}else if(i>o&&i>m){let h=2*Math.sqrt(1+i-o-m);this._w=(u-l)/h,this._x=.25*h,this._y=(s+a)/h,this._z=(r+c)/h}else if(o>m){let h=2*Math.sqrt(1+o-i-m);this._w=(r-c)/h,this._x=(s+a)/h,this._y=.25*h,this._z=(l+u)/h}else{let h=2*Math.sqrt(1+m-i-o);this._w=(a-s)/h,this._x=(r+c)/h,this._y=(l+u)/h,this._z=.25*h}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs($e(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,a=e._w,o=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+a*o+s*c-r*l,this._y=s*u+a*l+r*o-i*c,this._z=r*u+a*c+i*l-s*o,this._w=a*u-i*o-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,a=e._w,o=this.dot(e);o<0&&(i=-i,s=-s,r=-r,a=-a,o=-o);let l=1-t;if(o<.9995){let c=Math.acos(o),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},V=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(cf.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(cf.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,a=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*a,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*a,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*a,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,a=e.y,o=e.z,l=e.w,c=2*(a*s-o*i),u=2*(o*t-r*s),m=2*(r*i-a*t);return this.x=t+l*c+a*m-o*u,this.y=i+l*u+o*c-r*m,this.z=s+l*m+r*u-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=$e(this.x,e.x,t.x),this.y=$e(this.y,e.y,t.y),this.z=$e(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=$e(this.x,e,t),this.y=$e(this.y,e,t),this.z=$e(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar($e(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,a=t.x,o=t.y,l=t.z;return this.x=s*l-r*o,this.y=r*a-i*l,this.z=i*o-s*a,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return iu.copy(this).projectOnVector(e),this.sub(iu)}reflect(e){return this.sub(iu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos($e(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},iu=new V,cf=new ei,Ne=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,a,o,l,c)}set(e,t,i,s,r,a,o,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=o,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=a,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,a=i[0],o=i[3],l=i[6],c=i[1],u=i[4],m=i[7],d=i[2],h=i[5],_=i[8],x=s[0],p=s[3],f=s[6],M=s[1],A=s[4],S=s[7],C=s[2],E=s[5],v=s[8];return r[0]=a*x+o*M+l*C,r[3]=a*p+o*A+l*E,r[6]=a*f+o*S+l*v,r[1]=c*x+u*M+m*C,r[4]=c*p+u*A+m*E,r[7]=c*f+u*S+m*v,r[2]=d*x+h*M+_*C,r[5]=d*p+h*A+_*E,r[8]=d*f+h*S+_*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],u=e[8];return t*a*u-t*o*c-i*r*u+i*o*l+s*r*c-s*a*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],u=e[8],m=u*a-o*c,d=o*l-u*r,h=c*r-a*l,_=t*m+i*d+s*h;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/_;return e[0]=m*x,e[1]=(s*c-u*i)*x,e[2]=(o*i-s*a)*x,e[3]=d*x,e[4]=(u*t-s*l)*x,e[5]=(s*r-o*t)*x,e[6]=h*x,e[7]=(i*l-c*t)*x,e[8]=(a*t-i*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,a,o){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*a+c*o)+a+e,-s*c,s*l,-s*(-c*a+l*o)+o+t,0,0,1),this}scale(e,t){return $r("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(su.makeScale(e,t)),this}rotate(e){return $r("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(su.makeRotation(-e)),this}translate(e,t){return $r("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(su.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},su=new Ne,uf=new Ne().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),hf=new Ne().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function b0(){let n={enabled:!0,workingColorSpace:Zr,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===tt&&(s.r=Mi(s.r),s.g=Mi(s.g),s.b=Mi(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===tt&&(s.r=ir(s.r),s.g=ir(s.g),s.b=ir(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ci?Jr:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Zr]:{primaries:e,whitePoint:i,transfer:Jr,toXYZ:uf,fromXYZ:hf,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:bn},outputColorSpaceConfig:{drawingBufferColorSpace:bn}},[bn]:{primaries:e,whitePoint:i,transfer:tt,toXYZ:uf,fromXYZ:hf,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:bn}}}),n}var Xe=b0();function Mi(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ir(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Ws,Qo=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Ws===void 0&&(Ws=Qr("canvas")),Ws.width=e.width,Ws.height=e.height;let s=Ws.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Ws}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Qr("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=Mi(r[a]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Mi(t[i]/255)*255):t[i]=Mi(t[i]);return{data:t,width:e.width,height:e.height}}else return Ie("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},M0=0,ar=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:M0++}),this.uuid=_a(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(ru(s[a].image)):r.push(ru(s[a]))}else r=ru(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function ru(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Qo.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ie("Texture: Unable to serialize Texture."),{})}var S0=0,au=new V,fn=class n extends jn{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Pn,s=Pn,r=mt,a=Ai,o=pn,l=jt,c=n.DEFAULT_ANISOTROPY,u=Ci){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:S0++}),this.uuid=_a(),this.name="",this.source=new ar(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new Ye(0,0),this.repeat=new Ye(1,1),this.center=new Ye(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ne,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(au).x}get height(){return this.source.getSize(au).y}get depth(){return this.source.getSize(au).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ie(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ie(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Gu)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Yo:e.x=e.x-Math.floor(e.x);break;case Pn:e.x=e.x<0?0:1;break;case Zo:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Yo:e.y=e.y-Math.floor(e.y);break;case Pn:e.y=e.y<0?0:1;break;case Zo:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};fn.DEFAULT_IMAGE=null;fn.DEFAULT_MAPPING=Gu;fn.DEFAULT_ANISOTROPY=1;var xt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,a=e.elements;return this.x=a[0]*t+a[4]*i+a[8]*s+a[12]*r,this.y=a[1]*t+a[5]*i+a[9]*s+a[13]*r,this.z=a[2]*t+a[6]*i+a[10]*s+a[14]*r,this.w=a[3]*t+a[7]*i+a[11]*s+a[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],m=l[8],d=l[1],h=l[5],_=l[9],x=l[2],p=l[6],f=l[10];if(Math.abs(u-d)<.01&&Math.abs(m-x)<.01&&Math.abs(_-p)<.01){if(Math.abs(u+d)<.1&&Math.abs(m+x)<.1&&Math.abs(_+p)<.1&&Math.abs(c+h+f-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,S=(h+1)/2,C=(f+1)/2,E=(u+d)/4,v=(m+x)/4,w=(_+p)/4;return A>S&&A>C?A<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(A),s=E/i,r=v/i):S>C?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=E/s,r=w/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=v/r,s=w/r),this.set(i,s,r,t),this}let M=Math.sqrt((p-_)*(p-_)+(m-x)*(m-x)+(d-u)*(d-u));return Math.abs(M)<.001&&(M=1),this.x=(p-_)/M,this.y=(m-x)/M,this.z=(d-u)/M,this.w=Math.acos((c+h+f-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=$e(this.x,e.x,t.x),this.y=$e(this.y,e.y,t.y),this.z=$e(this.z,e.z,t.z),this.w=$e(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=$e(this.x,e,t),this.y=$e(this.y,e,t),this.z=$e(this.z,e,t),this.w=$e(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar($e(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},jo=class extends jn{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:mt,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new xt(0,0,e,t),this.scissorTest=!1,this.viewport=new xt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new fn({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:mt,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new ar(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Gt=class extends jo{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},jr=class extends fn{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Vt,this.minFilter=Vt,this.wrapR=Pn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var el=class extends fn{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Vt,this.minFilter=Vt,this.wrapR=Pn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var lt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,a,o,l,c,u,m,d,h,_,x,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,a,o,l,c,u,m,d,h,_,x,p)}set(e,t,i,s,r,a,o,l,c,u,m,d,h,_,x,p){let f=this.elements;return f[0]=e,f[4]=t,f[8]=i,f[12]=s,f[1]=r,f[5]=a,f[9]=o,f[13]=l,f[2]=c,f[6]=u,f[10]=m,f[14]=d,f[3]=h,f[7]=_,f[11]=x,f[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Xs.setFromMatrixColumn(e,0).length(),r=1/Xs.setFromMatrixColumn(e,1).length(),a=1/Xs.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*a,t[9]=i[9]*a,t[10]=i[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,a=Math.cos(i),o=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),m=Math.sin(r);if(e.order==="XYZ"){let d=a*u,h=a*m,_=o*u,x=o*m;t[0]=l*u,t[4]=-l*m,t[8]=c,t[1]=h+_*c,t[5]=d-x*c,t[9]=-o*l,t[2]=x-d*c,t[6]=_+h*c,t[10]=a*l}else if(e.order==="YXZ"){let d=l*u,h=l*m,_=c*u,x=c*m;t[0]=d+x*o,t[4]=_*o-h,t[8]=a*c,t[1]=a*m,t[5]=a*u,t[9]=-o,t[2]=h*o-_,t[6]=x+d*o,t[10]=a*l}else if(e.order==="ZXY"){let d=l*u,h=l*m,_=c*u,x=c*m;t[0]=d-x*o,t[4]=-a*m,t[8]=_+h*o,t[1]=h+_*o,t[5]=a*u,t[9]=x-d*o,t[2]=-a*c,t[6]=o,t[10]=a*l}else if(e.order==="ZYX"){let d=a*u,h=a*m,_=o*u,x=o*m;t[0]=l*u,t[4]=_*c-h,t[8]=d*c+x,t[1]=l*m,t[5]=x*c+d,t[9]=h*c-_,t[2]=-c,t[6]=o*l,t[10]=a*l}else if(e.order==="YZX"){let d=a*l,h=a*c,_=o*l,x=o*c;t[0]=l*u,t[4]=x-d*m,t[8]=_*m+h,t[1]=m,t[5]=a*u,t[9]=-o*u,t[2]=-c*u,t[6]=h*m+_,t[10]=d-x*m}else if(e.order==="XZY"){let d=a*l,h=a*c,_=o*l,x=o*c;t[0]=l*u,t[4]=-m,t[8]=c*u,t[1]=d*m+x,t[5]=a*u,t[9]=h*m-_,t[2]=_*m-h,t[6]=o*u,t[10]=x*m+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(w0,e,T0)}lookAt(e,t,i){let s=this.elements;return xn.subVectors(e,t),xn.lengthSq()===0&&(xn.z=1),xn.normalize(),ki.crossVectors(i,xn),ki.lengthSq()===0&&(Math.abs(i.z)===1?xn.x+=1e-4:xn.z+=1e-4,xn.normalize(),ki.crossVectors(i,xn)),ki.normalize(),xo.crossVectors(xn,ki),s[0]=ki.x,s[4]=xo.x,s[8]=xn.x,s[1]=ki.y,s[5]=xo.y,s[9]=xn.y,s[2]=ki.z,s[6]=xo.z,s[10]=xn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,a=i[0],o=i[4],l=i[8],c=i[12],u=i[1],m=i[5],d=i[9],h=i[13],_=i[2],x=i[6],p=i[10],f=i[14],M=i[3],A=i[7],S=i[11],C=i[15],E=s[0],v=s[4],w=s[8],B=s[12],L=s[1],D=s[5],k=s[9],H=s[13],I=s[2],q=s[6],K=s[10],G=s[14],ne=s[3],X=s[7],j=s[11],ee=s[15];return r[0]=a*E+o*L+l*I+c*ne,r[4]=a*v+o*D+l*q+c*X,r[8]=a*w+o*k+l*K+c*j,r[12]=a*B+o*H+l*G+c*ee,r[1]=u*E+m*L+d*I+h*ne,r[5]=u*v+m*D+d*q+h*X,r[9]=u*w+m*k+d*K+h*j,r[13]=u*B+m*H+d*G+h*ee,r[2]=_*E+x*L+p*I+f*ne,r[6]=_*v+x*D+p*q+f*X,r[10]=_*w+x*k+p*K+f*j,r[14]=_*B+x*H+p*G+f*ee,r[3]=M*E+A*L+S*I+C*ne,r[7]=M*v+A*D+S*q+C*X,r[11]=M*w+A*k+S*K+C*j,r[15]=M*B+A*H+S*G+C*ee,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],a=e[1],o=e[5],l=e[9],c=e[13],u=e[2],m=e[6],d=e[10],h=e[14],_=e[3],x=e[7],p=e[11],f=e[15],M=l*h-c*d,A=o*h-c*m,S=o*d-l*m,C=a*h-c*u,E=a*d-l*u,v=a*m-o*u;return t*(x*M-p*A+f*S)-i*(_*M-p*C+f*E)+s*(_*A-x*C+f*v)-r*(_*S-x*E+p*v)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],a=e[5],o=e[9],l=e[2],c=e[6],u=e[10];return t*(a*u-o*c)-i*(r*u-o*l)+s*(r*c-a*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],u=e[8],m=e[9],d=e[10],h=e[11],_=e[12],x=e[13],p=e[14],f=e[15],M=t*o-i*a,A=t*l-s*a,S=t*c-r*a,C=i*l-s*o,E=i*c-r*o,v=s*c-r*l,w=u*x-m*_,B=u*p-d*_,L=u*f-h*_,D=m*p-d*x,k=m*f-h*x,H=d*f-h*p,I=M*H-A*k+S*D+C*L-E*B+v*w;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let q=1/I;return e[0]=(o*H-l*k+c*D)*q,e[1]=(s*k-i*H-r*D)*q,e[2]=(x*v-p*E+f*C)*q,e[3]=(d*E-m*v-h*C)*q,e[4]=(l*L-a*H-c*B)*q,e[5]=(t*H-s*L+r*B)*q,e[6]=(p*S-_*v-f*A)*q,e[7]=(u*v-d*S+h*A)*q,e[8]=(a*k-o*L+c*w)*q,e[9]=(i*L-t*k-r*w)*q,e[10]=(_*E-x*S+f*M)*q,e[11]=(m*S-u*E-h*M)*q,e[12]=(o*B-a*D-l*w)*q,e[13]=(t*D-i*B+s*w)*q,e[14]=(x*A-_*C-p*M)*q,e[15]=(u*C-m*A+d*M)*q,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,a=e.x,o=e.y,l=e.z,c=r*a,u=r*o;return this.set(c*a+i,c*o-s*l,c*l+s*o,0,c*o+s*l,u*o+i,u*l-s*a,0,c*l-s*o,u*l+s*a,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,a){return this.set(1,i,r,0,e,1,a,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,a=t._y,o=t._z,l=t._w,c=r+r,u=a+a,m=o+o,d=r*c,h=r*u,_=r*m,x=a*u,p=a*m,f=o*m,M=l*c,A=l*u,S=l*m,C=i.x,E=i.y,v=i.z;return s[0]=(1-(x+f))*C,s[1]=(h+S)*C,s[2]=(_-A)*C,s[3]=0,s[4]=(h-S)*E,s[5]=(1-(d+f))*E,s[6]=(p+M)*E,s[7]=0,s[8]=(_+A)*v,s[9]=(p-M)*v,s[10]=(1-(d+x))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let a=Xs.set(s[0],s[1],s[2]).length(),o=Xs.set(s[4],s[5],s[6]).length(),l=Xs.set(s[8],s[9],s[10]).length();r<0&&(a=-a),Vn.copy(this);let c=1/a,u=1/o,m=1/l;return Vn.elements[0]*=c,Vn.elements[1]*=c,Vn.elements[2]*=c,Vn.elements[4]*=u,Vn.elements[5]*=u,Vn.elements[6]*=u,Vn.elements[8]*=m,Vn.elements[9]*=m,Vn.elements[10]*=m,t.setFromRotationMatrix(Vn),i.x=a,i.y=o,i.z=l,this}makePerspective(e,t,i,s,r,a,o=In,l=!1){let c=this.elements,u=2*r/(t-e),m=2*r/(i-s),d=(t+e)/(t-e),h=(i+s)/(i-s),_,x;if(l)_=r/(a-r),x=a*r/(a-r);else if(o===In)_=-(a+r)/(a-r),x=-2*a*r/(a-r);else if(o===Kr)_=-a/(a-r),x=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=m,c[9]=h,c[13]=0,c[2]=0,c[6]=0,c[10]=_,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,a,o=In,l=!1){let c=this.elements,u=2/(t-e),m=2/(i-s),d=-(t+e)/(t-e),h=-(i+s)/(i-s),_,x;if(l)_=1/(a-r),x=a/(a-r);else if(o===In)_=-2/(a-r),x=-(a+r)/(a-r);else if(o===Kr)_=-1/(a-r),x=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=m,c[9]=0,c[13]=h,c[2]=0,c[6]=0,c[10]=_,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Xs=new V,Vn=new lt,w0=new V(0,0,0),T0=new V(1,1,1),ki=new V,xo=new V,xn=new V,df=new lt,ff=new ei,Xi=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],u=s[9],m=s[2],d=s[6],h=s[10];switch(t){case"XYZ":this._y=Math.asin($e(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-u,h),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-$e(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(o,h),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-m,r),this._z=0);break;case"ZXY":this._x=Math.asin($e(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-m,h),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-$e(m,-1,1)),Math.abs(m)<.9999999?(this._x=Math.atan2(d,h),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin($e(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-m,r)):(this._x=0,this._y=Math.atan2(o,h));break;case"XZY":this._z=Math.asin(-$e(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-u,h),this._y=0);break;default:Ie("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return df.makeRotationFromQuaternion(e),this.setFromRotationMatrix(df,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return ff.setFromEuler(this),this.setFromQuaternion(ff,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Xi.DEFAULT_ORDER="XYZ";var ea=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},A0=0,pf=new V,qs=new ei,_i=new lt,yo=new V,Hr=new V,E0=new V,C0=new ei,mf=new V(1,0,0),gf=new V(0,1,0),_f=new V(0,0,1),vf={type:"added"},R0={type:"removed"},$s={type:"childadded",child:null},ou={type:"childremoved",child:null},Nn=class n extends jn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:A0++}),this.uuid=_a(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new V,t=new Xi,i=new ei,s=new V(1,1,1);function r(){i.setFromEuler(t,!1)}function a(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new lt},normalMatrix:{value:new Ne}}),this.matrix=new lt,this.matrixWorld=new lt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ea,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return qs.setFromAxisAngle(e,t),this.quaternion.multiply(qs),this}rotateOnWorldAxis(e,t){return qs.setFromAxisAngle(e,t),this.quaternion.premultiply(qs),this}rotateX(e){return this.rotateOnAxis(mf,e)}rotateY(e){return this.rotateOnAxis(gf,e)}rotateZ(e){return this.rotateOnAxis(_f,e)}translateOnAxis(e,t){return pf.copy(e).applyQuaternion(this.quaternion),this.position.add(pf.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(mf,e)}translateY(e){return this.translateOnAxis(gf,e)}translateZ(e){return this.translateOnAxis(_f,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(_i.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?yo.copy(e):yo.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Hr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?_i.lookAt(Hr,yo,this.up):_i.lookAt(yo,Hr,this.up),this.quaternion.setFromRotationMatrix(_i),s&&(_i.extractRotation(s.matrixWorld),qs.setFromRotationMatrix(_i),this.quaternion.premultiply(qs.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Le("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(vf),$s.child=e,this.dispatchEvent($s),$s.child=null):Le("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(R0),ou.child=e,this.dispatchEvent(ou),ou.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),_i.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),_i.multiply(e.parent.matrixWorld)),e.applyMatrix4(_i),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(vf),$s.child=e,this.dispatchEvent($s),$s.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let a=this.children[i].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Hr,e,E0),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Hr,C0,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let m=l[c];r(e.shapes,m)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(e.materials,this.material[l]));s.material=o}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];s.animations.push(r(e.animations,l))}}if(t){let o=a(e.geometries),l=a(e.materials),c=a(e.textures),u=a(e.images),m=a(e.shapes),d=a(e.skeletons),h=a(e.animations),_=a(e.nodes);o.length>0&&(i.geometries=o),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),m.length>0&&(i.shapes=m),d.length>0&&(i.skeletons=d),h.length>0&&(i.animations=h),_.length>0&&(i.nodes=_)}return i.object=s,i;function a(o){let l=[];for(let c in o){let u=o[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Nn.DEFAULT_UP=new V(0,1,0);Nn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ys=class extends Nn{constructor(){super(),this.isGroup=!0,this.type="Group"}},P0={type:"move"},or=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ys,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ys,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new V,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new V),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ys,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new V,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new V,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,a=null,o=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){a=!0;for(let x of e.hand.values()){let p=t.getJointPose(x,i),f=this._getHandJoint(c,x);p!==null&&(f.matrix.fromArray(p.transform.matrix),f.matrix.decompose(f.position,f.quaternion,f.scale),f.matrixWorldNeedsUpdate=!0,f.jointRadius=p.radius),f.visible=p!==null}let u=c.joints["index-finger-tip"],m=c.joints["thumb-tip"],d=u.position.distanceTo(m.position),h=.02,_=.005;c.inputState.pinching&&d>h+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=h-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(P0)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new ys;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},fp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},zi={h:0,s:0,l:0},bo={h:0,s:0,l:0};function lu(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var Ke=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=bn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Xe.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=Xe.workingColorSpace){return this.r=e,this.g=t,this.b=i,Xe.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=Xe.workingColorSpace){if(e=v0(e,1),t=$e(t,0,1),i=$e(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,a=2*i-r;this.r=lu(a,r,e+1/3),this.g=lu(a,r,e),this.b=lu(a,r,e-1/3)}return Xe.colorSpaceToWorking(this,s),this}setStyle(e,t=bn){function i(r){r!==void 0&&parseFloat(r)<1&&Ie("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ie("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(r,16),t);Ie("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=bn){let i=fp[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ie("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Mi(e.r),this.g=Mi(e.g),this.b=Mi(e.b),this}copyLinearToSRGB(e){return this.r=ir(e.r),this.g=ir(e.g),this.b=ir(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=bn){return Xe.workingToColorSpace(Qt.copy(this),e),Math.round($e(Qt.r*255,0,255))*65536+Math.round($e(Qt.g*255,0,255))*256+Math.round($e(Qt.b*255,0,255))}getHexString(e=bn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Xe.workingColorSpace){Xe.workingToColorSpace(Qt.copy(this),t);let i=Qt.r,s=Qt.g,r=Qt.b,a=Math.max(i,s,r),o=Math.min(i,s,r),l,c,u=(o+a)/2;if(o===a)l=0,c=0;else{let m=a-o;switch(c=u<=.5?m/(a+o):m/(2-a-o),a){case i:l=(s-r)/m+(s<r?6:0);break;case s:l=(r-i)/m+2;break;case r:l=(i-s)/m+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=Xe.workingColorSpace){return Xe.workingToColorSpace(Qt.copy(this),t),e.r=Qt.r,e.g=Qt.g,e.b=Qt.b,e}getStyle(e=bn){Xe.workingToColorSpace(Qt.copy(this),e);let t=Qt.r,i=Qt.g,s=Qt.b;return e!==bn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(zi),this.setHSL(zi.h+e,zi.s+t,zi.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(zi),e.getHSL(bo);let i=nu(zi.h,bo.h,t),s=nu(zi.s,bo.s,t),r=nu(zi.l,bo.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Qt=new Ke;Ke.NAMES=fp;var wi=class extends Nn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Xi,this.environmentIntensity=1,this.environmentRotation=new Xi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Gn=new V,vi=new V,cu=new V,xi=new V,Ys=new V,Zs=new V,xf=new V,uu=new V,hu=new V,du=new V,fu=new xt,pu=new xt,mu=new xt,Wi=class n{constructor(e=new V,t=new V,i=new V){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Gn.subVectors(e,t),s.cross(Gn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Gn.subVectors(s,t),vi.subVectors(i,t),cu.subVectors(e,t);let a=Gn.dot(Gn),o=Gn.dot(vi),l=Gn.dot(cu),c=vi.dot(vi),u=vi.dot(cu),m=a*c-o*o;if(m===0)return r.set(0,0,0),null;let d=1/m,h=(c*l-o*u)*d,_=(a*u-o*l)*d;return r.set(1-h-_,_,h)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,xi)===null?!1:xi.x>=0&&xi.y>=0&&xi.x+xi.y<=1}static getInterpolation(e,t,i,s,r,a,o,l){return this.getBarycoord(e,t,i,s,xi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,xi.x),l.addScaledVector(a,xi.y),l.addScaledVector(o,xi.z),l)}static getInterpolatedAttribute(e,t,i,s,r,a){return fu.setScalar(0),pu.setScalar(0),mu.setScalar(0),fu.fromBufferAttribute(e,t),pu.fromBufferAttribute(e,i),mu.fromBufferAttribute(e,s),a.setScalar(0),a.addScaledVector(fu,r.x),a.addScaledVector(pu,r.y),a.addScaledVector(mu,r.z),a}static isFrontFacing(e,t,i,s){return Gn.subVectors(i,t),vi.subVectors(e,t),Gn.cross(vi).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Gn.subVectors(this.c,this.b),vi.subVectors(this.a,this.b),Gn.cross(vi).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,a,o;Ys.subVectors(s,i),Zs.subVectors(r,i),uu.subVectors(e,i);let l=Ys.dot(uu),c=Zs.dot(uu);if(l<=0&&c<=0)return t.copy(i);hu.subVectors(e,s);let u=Ys.dot(hu),m=Zs.dot(hu);if(u>=0&&m<=u)return t.copy(s);let d=l*m-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return a=l/(l-u),t.copy(i).addScaledVector(Ys,a);du.subVectors(e,r);let h=Ys.dot(du),_=Zs.dot(du);if(_>=0&&h<=_)return t.copy(r);let x=h*c-l*_;if(x<=0&&c>=0&&_<=0)return o=c/(c-_),t.copy(i).addScaledVector(Zs,o);let p=u*_-h*m;if(p<=0&&m-u>=0&&h-_>=0)return xf.subVectors(r,s),o=(m-u)/(m-u+(h-_)),t.copy(s).addScaledVector(xf,o);let f=1/(p+x+d);return a=x*f,o=d*f,t.copy(i).addScaledVector(Ys,a).addScaledVector(Zs,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},qi=class{constructor(e=new V(1/0,1/0,1/0),t=new V(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Hn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Hn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Hn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,Hn):Hn.fromBufferAttribute(r,a),Hn.applyMatrix4(e.matrixWorld),this.expandByPoint(Hn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Mo.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Mo.copy(i.boundingBox)),Mo.applyMatrix4(e.matrixWorld),this.union(Mo)}let s=e.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Hn),Hn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Wr),So.subVectors(this.max,Wr),Js.subVectors(e.a,Wr),Ks.subVectors(e.b,Wr),Qs.subVectors(e.c,Wr),Vi.subVectors(Ks,Js),Gi.subVectors(Qs,Ks),gs.subVectors(Js,Qs);let t=[0,-Vi.z,Vi.y,0,-Gi.z,Gi.y,0,-gs.z,gs.y,Vi.z,0,-Vi.x,Gi.z,0,-Gi.x,gs.z,0,-gs.x,-Vi.y,Vi.x,0,-Gi.y,Gi.x,0,-gs.y,gs.x,0];return!gu(t,Js,Ks,Qs,So)||(t=[1,0,0,0,1,0,0,0,1],!gu(t,Js,Ks,Qs,So))?!1:(wo.crossVectors(Vi,Gi),t=[wo.x,wo.y,wo.z],gu(t,Js,Ks,Qs,So))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Hn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Hn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(yi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),yi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),yi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),yi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),yi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),yi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),yi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),yi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(yi),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},yi=[new V,new V,new V,new V,new V,new V,new V,new V],Hn=new V,Mo=new qi,Js=new V,Ks=new V,Qs=new V,Vi=new V,Gi=new V,gs=new V,Wr=new V,So=new V,wo=new V,_s=new V;function gu(n,e,t,i,s){for(let r=0,a=n.length-3;r<=a;r+=3){_s.fromArray(n,r);let o=s.x*Math.abs(_s.x)+s.y*Math.abs(_s.y)+s.z*Math.abs(_s.z),l=e.dot(_s),c=t.dot(_s),u=i.dot(_s);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>o)return!1}return!0}var Et=new V,To=new Ye,I0=0,dn=class extends jn{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:I0++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=op,this.updateRanges=[],this.gpuType=Sn,this.version=0,this._normalizationScale=e!==void 0?th(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)To.fromBufferAttribute(this,t),To.applyMatrix3(e),this.setXY(t,To.x,To.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Et.fromBufferAttribute(this,t),Et.applyMatrix3(e),this.setXYZ(t,Et.x,Et.y,Et.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Et.fromBufferAttribute(this,t),Et.applyMatrix4(e),this.setXYZ(t,Et.x,Et.y,Et.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Et.fromBufferAttribute(this,t),Et.applyNormalMatrix(e),this.setXYZ(t,Et.x,Et.y,Et.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Et.fromBufferAttribute(this,t),Et.transformDirection(e),this.setXYZ(t,Et.x,Et.y,Et.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):x0(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):y0(e,this.array)}};var ta=class extends dn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var na=class extends dn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Ln=class extends dn{constructor(e,t,i){super(new Float32Array(e),t,i)}},L0=new qi,Xr=new V,_u=new V,lr=class{constructor(e=new V,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):L0.setFromPoints(e).getCenter(i);let s=0;for(let r=0,a=e.length;r<a;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Xr.subVectors(e,this.center);let t=Xr.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Xr,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(_u.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Xr.copy(e.center).add(_u)),this.expandByPoint(Xr.copy(e.center).sub(_u))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},N0=0,Rn=new lt,vu=new Nn,js=new V,yn=new qi,qr=new qi,zt=new V,ti=class n extends jn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:N0++}),this.uuid=_a(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(g0(e)?na:ta)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Ne().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Rn.makeRotationFromQuaternion(e),this.applyMatrix4(Rn),this}rotateX(e){return Rn.makeRotationX(e),this.applyMatrix4(Rn),this}rotateY(e){return Rn.makeRotationY(e),this.applyMatrix4(Rn),this}rotateZ(e){return Rn.makeRotationZ(e),this.applyMatrix4(Rn),this}translate(e,t,i){return Rn.makeTranslation(e,t,i),this.applyMatrix4(Rn),this}scale(e,t,i){return Rn.makeScale(e,t,i),this.applyMatrix4(Rn),this}lookAt(e){return vu.lookAt(e),vu.updateMatrix(),this.applyMatrix4(vu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(js).negate(),this.translate(js.x,js.y,js.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let a=e[s];i.push(a.x,a.y,a.z||0)}this.setAttribute("position",new Ln(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ie("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new qi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Le("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new V(-1/0,-1/0,-1/0),new V(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];yn.setFromBufferAttribute(r),this.morphTargetsRelative?(zt.addVectors(this.boundingBox.min,yn.min),this.boundingBox.expandByPoint(zt),zt.addVectors(this.boundingBox.max,yn.max),this.boundingBox.expandByPoint(zt)):(this.boundingBox.expandByPoint(yn.min),this.boundingBox.expandByPoint(yn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Le('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new lr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Le("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new V,1/0);return}if(e){let i=this.boundingSphere.center;if(yn.setFromBufferAttribute(e),t)for(let r=0,a=t.length;r<a;r++){let o=t[r];qr.setFromBufferAttribute(o),this.morphTargetsRelative?(zt.addVectors(yn.min,qr.min),yn.expandByPoint(zt),zt.addVectors(yn.max,qr.max),yn.expandByPoint(zt)):(yn.expandByPoint(qr.min),yn.expandByPoint(qr.max))}yn.getCenter(i);let s=0;for(let r=0,a=e.count;r<a;r++)zt.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(zt));if(t)for(let r=0,a=t.length;r<a;r++){let o=t[r],l=this.morphTargetsRelative;for(let c=0,u=o.count;c<u;c++)zt.fromBufferAttribute(o,c),l&&(js.fromBufferAttribute(e,c),zt.add(js)),s=Math.max(s,i.distanceToSquared(zt))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Le('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Le("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==i.count)&&(a=new dn(new Float32Array(4*i.count),4),this.setAttribute("tangent",a));let o=[],l=[],c=new Uint8Array(i.count);for(let B=0;B<i.count;B++)o[B]=new V,l[B]=new V;let u=new V,m=new V,d=new V,h=new Ye,_=new Ye,x=new Ye,p=new V,f=new V;function M(B,L,D){c[B]=c[L]=c[D]=1,u.fromBufferAttribute(i,B),m.fromBufferAttribute(i,L),d.fromBufferAttribute(i,D),h.fromBufferAttribute(r,B),_.fromBufferAttribute(r,L),x.fromBufferAttribute(r,D),m.sub(u),d.sub(u),_.sub(h),x.sub(h);let k=1/(_.x*x.y-x.x*_.y);isFinite(k)&&(p.copy(m).multiplyScalar(x.y).addScaledVector(d,-_.y).multiplyScalar(k),f.copy(d).multiplyScalar(_.x).addScaledVector(m,-x.x).multiplyScalar(k),o[B].add(p),o[L].add(p),o[D].add(p),l[B].add(f),l[L].add(f),l[D].add(f))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let B=0,L=A.length;B<L;++B){let D=A[B],k=D.start,H=D.count;for(let I=k,q=k+H;I<q;I+=3)M(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let S=new V,C=new V,E=new V,v=new V;function w(B){E.fromBufferAttribute(s,B),v.copy(E);let L=o[B];S.copy(L),S.sub(E.multiplyScalar(E.dot(L))).normalize(),C.crossVectors(v,L);let k=C.dot(l[B])<0?-1:1;a.setXYZW(B,S.x,S.y,S.z,k)}for(let B=0,L=i.count;B<L;++B)c[B]&&w(B);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new dn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,h=i.count;d<h;d++)i.setXYZ(d,0,0,0);let s=new V,r=new V,a=new V,o=new V,l=new V,c=new V,u=new V,m=new V;if(e)for(let d=0,h=e.count;d<h;d+=3){let _=e.getX(d+0),x=e.getX(d+1),p=e.getX(d+2);s.fromBufferAttribute(t,_),r.fromBufferAttribute(t,x),a.fromBufferAttribute(t,p),u.subVectors(a,r),m.subVectors(s,r),u.cross(m),o.fromBufferAttribute(i,_),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,p),o.add(u),l.add(u),c.add(u),i.setXYZ(_,o.x,o.y,o.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,h=t.count;d<h;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),a.fromBufferAttribute(t,d+2),u.subVectors(a,r),m.subVectors(s,r),u.cross(m),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)zt.fromBufferAttribute(e,t),zt.normalize(),e.setXYZ(t,zt.x,zt.y,zt.z)}toNonIndexed(){function e(o,l){let c=o.array,u=o.itemSize,m=o.normalized,d=new c.constructor(l.length*u),h=0,_=0;for(let x=0,p=l.length;x<p;x++){o.isInterleavedBufferAttribute?h=l[x]*o.data.stride+o.offset:h=l[x]*u;for(let f=0;f<u;f++)d[_++]=c[h++]}return new dn(d,u,m)}if(this.index===null)return Ie("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let o in s){let l=s[o],c=e(l,i);t.setAttribute(o,c)}let r=this.morphAttributes;for(let o in r){let l=[],c=r[o];for(let u=0,m=c.length;u<m;u++){let d=c[u],h=e(d,i);l.push(h)}t.morphAttributes[o]=l}t.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,l=a.length;o<l;o++){let c=a[o];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let m=0,d=c.length;m<d;m++){let h=c[m];u.push(h.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],m=r[c];for(let d=0,h=m.length;d<h;d++)u.push(m[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let a=e.groups;for(let c=0,u=a.length;c<u;c++){let m=a[c];this.addGroup(m.start,m.count,m.materialIndex)}let o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var xu=new V,D0=new V,U0=new Ne,Wn=class{constructor(e=new V(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=xu.subVectors(i,t).cross(D0.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(xu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let a=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(s,a)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||U0.getNormalMatrix(e),s=this.coplanarPoint(xu).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},F0=0,bs=class extends jn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:F0++}),this.uuid=_a(),this.name="",this.type="Material",this.blending=dr,this.side=Qi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Lu,this.blendDst=Nu,this.blendEquation=ws,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ke(0,0,0),this.blendAlpha=0,this.depthFunc=sr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=tp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=zo,this.stencilZFail=zo,this.stencilZPass=zo,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ie(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ie(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let a=[];for(let o in r){let l=r[o];delete l.metadata,a.push(l)}return a}if(t){let r=s(e.textures),a=s(e.images);r.length>0&&(i.textures=r),a.length>0&&(i.images=a)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Ke().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Wn().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ye().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ye().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var bi=new V,yu=new V,Ao=new V,Eo=new V,tl=class{constructor(e=new V,t=new V(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,bi)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=bi.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(bi.copy(this.origin).addScaledVector(this.direction,t),bi.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){yu.copy(e).add(t).multiplyScalar(.5),Ao.copy(t).sub(e).normalize(),Eo.copy(this.origin).sub(yu);let r=e.distanceTo(t)*.5,a=-this.direction.dot(Ao),o=Eo.dot(this.direction),l=-Eo.dot(Ao),c=Eo.lengthSq(),u=Math.abs(1-a*a),m,d,h,_;if(u>0)if(m=a*l-o,d=a*o-l,_=r*u,m>=0)if(d>=-_)if(d<=_){let x=1/u;m*=x,d*=x,h=m*(m+a*d+2*o)+d*(a*m+d+2*l)+c}else d=r,m=Math.max(0,-(a*d+o)),h=-m*m+d*(d+2*l)+c;else d=-r,m=Math.max(0,-(a*d+o)),h=-m*m+d*(d+2*l)+c;else d<=-_?(m=Math.max(0,-(-a*r+o)),d=m>0?-r:Math.min(Math.max(-r,-l),r),h=-m*m+d*(d+2*l)+c):d<=_?(m=0,d=Math.min(Math.max(-r,-l),r),h=d*(d+2*l)+c):(m=Math.max(0,-(a*r+o)),d=m>0?r:Math.min(Math.max(-r,-l),r),h=-m*m+d*(d+2*l)+c);else d=a>0?-r:r,m=Math.max(0,-(a*d+o)),h=-m*m+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,m),s&&s.copy(yu).addScaledVector(Ao,d),h}intersectSphere(e,t){if(e.radius<0)return null;bi.subVectors(e.center,this.origin);let i=bi.dot(this.direction),s=bi.dot(bi)-i*i,r=e.radius*e.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=i-a,l=i+a;return l<0?null:o<0?this.at(l,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,a,o,l,c=1/this.direction.x,u=1/this.direction.y,m=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,a=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,a=(e.min.y-d.y)*u),i>a||r>s||((r>i||isNaN(i))&&(i=r),(a<s||isNaN(s))&&(s=a),m>=0?(o=(e.min.z-d.z)*m,l=(e.max.z-d.z)*m):(o=(e.max.z-d.z)*m,l=(e.min.z-d.z)*m),i>l||o>s)||((o>i||i!==i)&&(i=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,bi)!==null}intersectTriangle(e,t,i,s,r){let a=this.origin,o=this.direction,l=o.x,c=o.y,u=o.z,m=e.x-a.x,d=e.y-a.y,h=e.z-a.z,_=t.x-a.x,x=t.y-a.y,p=t.z-a.z,f=i.x-a.x,M=i.y-a.y,A=i.z-a.z,S=Math.abs(l),C=Math.abs(c),E=Math.abs(u),v,w,B,L,D,k,H,I,q,K,G,ne;if(S>=C&&S>=E?(B=l,k=m,q=_,ne=f,l>=0?(v=c,w=u,L=d,D=h,H=x,I=p,K=M,G=A):(v=u,w=c,L=h,D=d,H=p,I=x,K=A,G=M)):C>=E?(B=c,k=d,q=x,ne=M,c>=0?(v=u,w=l,L=h,D=m,H=p,I=_,K=A,G=f):(v=l,w=u,L=m,D=h,H=_,I=p,K=f,G=A)):(B=u,k=h,q=p,ne=A,u>=0?(v=l,w=c,L=m,D=d,H=_,I=x,K=f,G=M):(v=c,w=l,L=d,D=m,H=x,I=_,K=M,G=f)),B===0)return null;let X=v/B,j=w/B,ee=1/B,Me=L-X*k,Ue=D-j*k,Z=H-X*q,me=I-j*q,xe=K-X*ne,Ee=G-j*ne,ge=xe*me-Ee*Z,Oe=Me*Ee-Ue*xe,Mt=Z*Ue-me*Me;if(s){if(ge<0||Oe<0||Mt<0)return null}else if((ge<0||Oe<0||Mt<0)&&(ge>0||Oe>0||Mt>0))return null;let Re=ge+Oe+Mt;if(Re===0)return null;let nt=ee*(ge*k+Oe*q+Mt*ne);return(Re>0?nt<0:nt>0)?null:this.at(nt/Re,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},nl=class extends bs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ke(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Xi,this.combine=Du,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},yf=new lt,vs=new tl,Co=new lr,bf=new V,Ro=new V,Po=new V,Io=new V,bu=new V,Lo=new V,Mf=new V,No=new V,qt=class extends Nn{constructor(e=new ti,t=new nl){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,a=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let o=this.morphTargetInfluences;if(r&&o){Lo.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=o[l],m=r[l];u!==0&&(bu.fromBufferAttribute(m,e),a?Lo.addScaledVector(bu,u):Lo.addScaledVector(bu.sub(t),u))}t.add(Lo)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Co.copy(i.boundingSphere),Co.applyMatrix4(r),vs.copy(e.ray).recast(e.near),!(Co.containsPoint(vs.origin)===!1&&(vs.intersectSphere(Co,bf)===null||vs.origin.distanceToSquared(bf)>(e.far-e.near)**2))&&(yf.copy(r).invert(),vs.copy(e.ray).applyMatrix4(yf),!(i.boundingBox!==null&&vs.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,vs)))}_computeIntersections(e,t,i){let s,r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,m=r.attributes.normal,d=r.groups,h=r.drawRange;if(o!==null)if(Array.isArray(a))for(let _=0,x=d.length;_<x;_++){let p=d[_],f=a[p.materialIndex],M=Math.max(p.start,h.start),A=Math.min(o.count,Math.min(p.start+p.count,h.start+h.count));for(let S=M,C=A;S<C;S+=3){let E=o.getX(S),v=o.getX(S+1),w=o.getX(S+2);s=Do(this,f,e,i,c,u,m,E,v,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let _=Math.max(0,h.start),x=Math.min(o.count,h.start+h.count);for(let p=_,f=x;p<f;p+=3){let M=o.getX(p),A=o.getX(p+1),S=o.getX(p+2);s=Do(this,a,e,i,c,u,m,M,A,S),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let _=0,x=d.length;_<x;_++){let p=d[_],f=a[p.materialIndex],M=Math.max(p.start,h.start),A=Math.min(l.count,Math.min(p.start+p.count,h.start+h.count));for(let S=M,C=A;S<C;S+=3){let E=S,v=S+1,w=S+2;s=Do(this,f,e,i,c,u,m,E,v,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let _=Math.max(0,h.start),x=Math.min(l.count,h.start+h.count);for(let p=_,f=x;p<f;p+=3){let M=p,A=p+1,S=p+2;s=Do(this,a,e,i,c,u,m,M,A,S),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function O0(n,e,t,i,s,r,a,o){let l;if(e.side===on?l=i.intersectTriangle(a,r,s,!0,o):l=i.intersectTriangle(s,r,a,e.side===Qi,o),l===null)return null;No.copy(o),No.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(No);return c<t.near||c>t.far?null:{distance:c,point:No.clone(),object:n}}function Do(n,e,t,i,s,r,a,o,l,c){n.getVertexPosition(o,Ro),n.getVertexPosition(l,Po),n.getVertexPosition(c,Io);let u=O0(n,e,t,i,Ro,Po,Io,Mf);if(u){let m=new V;Wi.getBarycoord(Mf,Ro,Po,Io,m),s&&(u.uv=Wi.getInterpolatedAttribute(s,o,l,c,m,new Ye)),r&&(u.uv1=Wi.getInterpolatedAttribute(r,o,l,c,m,new Ye)),a&&(u.normal=Wi.getInterpolatedAttribute(a,o,l,c,m,new V),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a:o,b:l,c,normal:new V,materialIndex:0};Wi.getNormal(Ro,Po,Io,d.normal),u.face=d,u.barycoord=m}return u}var $i=class extends fn{constructor(e=null,t=1,i=1,s,r,a,o,l,c=Vt,u=Vt,m,d){super(null,a,o,l,c,u,s,r,m,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var xs=new lr,B0=new Ye(.5,.5),Uo=new V,Ms=class{constructor(e=new Wn,t=new Wn,i=new Wn,s=new Wn,r=new Wn,a=new Wn){this.planes=[e,t,i,s,r,a]}set(e,t,i,s,r,a){let o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(i),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=In,i=!1){let s=this.planes,r=e.elements,a=r[0],o=r[1],l=r[2],c=r[3],u=r[4],m=r[5],d=r[6],h=r[7],_=r[8],x=r[9],p=r[10],f=r[11],M=r[12],A=r[13],S=r[14],C=r[15];if(s[0].setComponents(c-a,h-u,f-_,C-M).normalize(),s[1].setComponents(c+a,h+u,f+_,C+M).normalize(),s[2].setComponents(c+o,h+m,f+x,C+A).normalize(),s[3].setComponents(c-o,h-m,f-x,C-A).normalize(),i)s[4].setComponents(l,d,p,S).normalize(),s[5].setComponents(c-l,h-d,f-p,C-S).normalize();else if(s[4].setComponents(c-l,h-d,f-p,C-S).normalize(),t===In)s[5].setComponents(c+l,h+d,f+p,C+S).normalize();else if(t===Kr)s[5].setComponents(l,d,p,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),xs.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),xs.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(xs)}intersectsSprite(e){xs.center.set(0,0,0);let t=B0.distanceTo(e.center);return xs.radius=.7071067811865476+t,xs.applyMatrix4(e.matrixWorld),this.intersectsSphere(xs)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Uo.x=s.normal.x>0?e.max.x:e.min.x,Uo.y=s.normal.y>0?e.max.y:e.min.y,Uo.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Uo)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Sf=new lt,il=class n{constructor(){this.coordinateSystem=In,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Sf.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Ms),i[s].setFromProjectionMatrix(Sf,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Ms),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var ia=class extends fn{constructor(e=[],t=Ts,i,s,r,a,o,l,c,u){super(e,t,i,s,r,a,o,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ti=class extends fn{constructor(e,t,i=Xn,s,r,a,o=Vt,l=Vt,c,u=Si,m=1){if(u!==Si&&u!==Ei)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:m};super(d,s,r,a,o,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ar(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},sa=class extends Ti{constructor(e,t=Xn,i=Ts,s,r,a=Vt,o=Vt,l,c=Si){let u={width:e,height:e,depth:1},m=[u,u,u,u,u,u];super(e,e,t,i,s,r,a,o,l,c),this.image=m,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ra=class extends fn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},cr=class n extends ti{constructor(e=1,t=1,i=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let l=[],c=[],u=[],m=[],d=0,h=0;_("z","y","x",-1,-1,i,t,e,a,r,0),_("z","y","x",1,-1,i,t,-e,a,r,1),_("x","z","y",1,1,e,i,t,s,a,2),_("x","z","y",1,-1,e,i,-t,s,a,3),_("x","y","z",1,-1,e,t,i,s,r,4),_("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Ln(c,3)),this.setAttribute("normal",new Ln(u,3)),this.setAttribute("uv",new Ln(m,2));function _(x,p,f,M,A,S,C,E,v,w,B){let L=S/v,D=C/w,k=S/2,H=C/2,I=E/2,q=v+1,K=w+1,G=0,ne=0,X=new V;for(let j=0;j<K;j++){let ee=j*D-H;for(let Me=0;Me<q;Me++){let Ue=Me*L-k;X[x]=Ue*M,X[p]=ee*A,X[f]=I,c.push(X.x,X.y,X.z),X[x]=0,X[p]=0,X[f]=E>0?1:-1,u.push(X.x,X.y,X.z),m.push(Me/v),m.push(1-j/w),G+=1}}for(let j=0;j<w;j++)for(let ee=0;ee<v;ee++){let Me=d+ee+q*j,Ue=d+ee+q*(j+1),Z=d+(ee+1)+q*(j+1),me=d+(ee+1)+q*j;l.push(Me,Ue,me),l.push(Ue,Z,me),ne+=6}o.addGroup(h,ne,B),h+=ne,d+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var aa=class n extends ti{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,a=t/2,o=Math.floor(i),l=Math.floor(s),c=o+1,u=l+1,m=e/o,d=t/l,h=[],_=[],x=[],p=[];for(let f=0;f<u;f++){let M=f*d-a;for(let A=0;A<c;A++){let S=A*m-r;_.push(S,-M,0),x.push(0,0,1),p.push(A/o),p.push(1-f/l)}}for(let f=0;f<l;f++)for(let M=0;M<o;M++){let A=M+c*f,S=M+c*(f+1),C=M+1+c*(f+1),E=M+1+c*f;h.push(A,S,E),h.push(S,C,E)}this.setIndex(h),this.setAttribute("position",new Ln(_,3)),this.setAttribute("normal",new Ln(x,3)),this.setAttribute("uv",new Ln(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};function Es(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(wf(s))s.isRenderTargetTexture?(Ie("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(wf(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function en(n){let e={};for(let t=0;t<n.length;t++){let i=Es(n[t]);for(let s in i)e[s]=i[s]}return e}function wf(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function k0(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function nh(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Xe.workingColorSpace}var pp={clone:Es,merge:en},z0=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,V0=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ni=class extends bs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=z0,this.fragmentShader=V0,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Es(e.uniforms),this.uniformsGroups=k0(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?t.uniforms[s]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[s]={type:"m4",value:a.toArray()}:t.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new Ke().setHex(s.value);break;case"v2":this.uniforms[i].value=new Ye().fromArray(s.value);break;case"v3":this.uniforms[i].value=new V().fromArray(s.value);break;case"v4":this.uniforms[i].value=new xt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new Ne().fromArray(s.value);break;case"m4":this.uniforms[i].value=new lt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},ii=class extends ni{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var sl=class extends bs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=jf,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},rl=class extends bs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function er(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Fo(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Yi=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let a;n:{i:if(!(e<s)){for(let o=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===o)break;if(r=s,s=t[++i],e<s)break t}a=t.length;break n}if(!(e>=r)){let o=t[1];e<o&&(i=2,r=o);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}a=i,i=0;break n}break e}for(;i<a;){let o=i+a>>>1;e<t[o]?a=o:i=o+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let a=0;a!==s;++a)t[a]=i[r+a];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},al=class extends Yi{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Su,endingEnd:Su}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,a=e+1,o=s[r],l=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case wu:r=e,o=2*t-i;break;case Tu:r=s.length-2,o=t+s[r]-s[r+1];break;default:r=e,o=i}if(l===void 0)switch(this.getSettings_().endingEnd){case wu:a=e,l=2*i-t;break;case Tu:a=1,l=i+s[1]-s[0];break;default:a=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-o),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=a*u}interpolate_(e,t,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,u=this._offsetPrev,m=this._offsetNext,d=this._weightPrev,h=this._weightNext,_=(i-t)/(s-t),x=_*_,p=x*_,f=-d*p+2*d*x-d*_,M=(1+d)*p+(-1.5-2*d)*x+(-.5+d)*_+1,A=(-1-h)*p+(1.5+h)*x+.5*_,S=h*p-h*x;for(let C=0;C!==o;++C)r[C]=f*a[u+C]+M*a[c+C]+A*a[l+C]+S*a[m+C];return r}},ol=class extends Yi{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,u=(i-t)/(s-t),m=1-u;for(let d=0;d!==o;++d)r[d]=a[c+d]*m+a[l+d]*u;return r}},ll=class extends Yi{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},cl=class extends Yi{interpolate_(e,t,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,u=this.inTangents,m=this.outTangents;if(!u||!m){let _=(i-t)/(s-t),x=1-_;for(let p=0;p!==o;++p)r[p]=a[c+p]*x+a[l+p]*_;return r}let d=o*2,h=e-1;for(let _=0;_!==o;++_){let x=a[c+_],p=a[l+_],f=h*d+_*2,M=m[f],A=m[f+1],S=e*d+_*2,C=u[S],E=u[S+1],v=H0(i,t,M,C,s);r[_]=mp(v,x,A,E,p)}return r}};function mp(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function G0(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function H0(n,e,t,i,s){let r=(n-e)/(s-e);for(let a=0;a<8;a++){let o=mp(r,e,t,i,s)-n;if(Math.abs(o)<1e-10)break;let l=G0(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-o/l))}return r}var Mn=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=er(t,this.TimeBufferType),this.values=er(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:er(e.times,Array),values:er(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Fo(e.settings)&&(i.settings={inTangents:er(e.settings.inTangents,Array),outTangents:er(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new ll(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new ol(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new al(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new cl(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Yr:t=this.InterpolantFactoryMethodDiscrete;break;case Jo:t=this.InterpolantFactoryMethodLinear;break;case ko:t=this.InterpolantFactoryMethodSmooth;break;case Mu:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ie("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Yr;case this.InterpolantFactoryMethodLinear:return Jo;case this.InterpolantFactoryMethodSmooth:return ko;case this.InterpolantFactoryMethodBezier:return Mu}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Fo(this.settings)&&(Tf(this.settings.inTangents,e),Tf(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Fo(this.settings)&&(Af(this.settings.inTangents,e),Af(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,a=s-1;for(;r!==s&&i[r]<e;)++r;for(;a!==-1&&i[a]>t;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=i.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Le("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Le("KeyframeTrack: Track is empty.",this),e=!1);let a=null;for(let o=0;o!==r;o++){let l=i[o];if(typeof l=="number"&&isNaN(l)){Le("KeyframeTrack: Time is not a valid number.",this,o,l),e=!1;break}if(a!==null&&a>l){Le("KeyframeTrack: Out of order keys.",this,o,l,a),e=!1;break}a=l}if(s!==void 0&&_0(s))for(let o=0,l=s.length;o!==l;++o){let c=s[o];if(isNaN(c)){Le("KeyframeTrack: Value is not a valid number.",this,o,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===ko,r=e.length-1,a=1;for(let o=1;o<r;++o){let l=!1,c=e[o],u=e[o+1];if(c!==u&&(o!==1||c!==e[0]))if(s)l=!0;else{let m=o*i,d=m-i,h=m+i;for(let _=0;_!==i;++_){let x=t[m+_];if(x!==t[d+_]||x!==t[h+_]){l=!0;break}}}if(l){if(o!==a){e[a]=e[o];let m=o*i,d=a*i;for(let h=0;h!==i;++h)t[d+h]=t[m+h]}++a}}if(r>0){e[a]=e[r];for(let o=r*i,l=a*i,c=0;c!==i;++c)t[l+c]=t[o+c];++a}return a!==e.length?(this.times=e.slice(0,a),this.values=t.slice(0,a*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Fo(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Tf(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function Af(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Mn.prototype.ValueTypeName="";Mn.prototype.TimeBufferType=Float32Array;Mn.prototype.ValueBufferType=Float32Array;Mn.prototype.DefaultInterpolation=Jo;var Zi=class extends Mn{constructor(e,t,i){super(e,t,i)}};Zi.prototype.ValueTypeName="bool";Zi.prototype.ValueBufferType=Array;Zi.prototype.DefaultInterpolation=Yr;Zi.prototype.InterpolantFactoryMethodLinear=void 0;Zi.prototype.InterpolantFactoryMethodSmooth=void 0;var ul=class extends Mn{constructor(e,t,i,s){super(e,t,i,s)}};ul.prototype.ValueTypeName="color";var hl=class extends Mn{constructor(e,t,i,s){super(e,t,i,s)}};hl.prototype.ValueTypeName="number";var dl=class extends Yi{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=(i-t)/(s-t),c=e*o;for(let u=c+o;c!==u;c+=4)ei.slerpFlat(r,0,a,c-o,a,c,l);return r}},oa=class extends Mn{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new dl(this.times,this.values,this.getValueSize(),e)}};oa.prototype.ValueTypeName="quaternion";oa.prototype.InterpolantFactoryMethodSmooth=void 0;var Ji=class extends Mn{constructor(e,t,i){super(e,t,i)}};Ji.prototype.ValueTypeName="string";Ji.prototype.ValueBufferType=Array;Ji.prototype.DefaultInterpolation=Yr;Ji.prototype.InterpolantFactoryMethodLinear=void 0;Ji.prototype.InterpolantFactoryMethodSmooth=void 0;var fl=class extends Mn{constructor(e,t,i,s){super(e,t,i,s)}};fl.prototype.ValueTypeName="vector";var pl=class{constructor(e,t,i){let s=this,r=!1,a=0,o=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){o++,r===!1&&s.onStart!==void 0&&s.onStart(u,a,o),r=!0},this.itemEnd=function(u){a++,s.onProgress!==void 0&&s.onProgress(u,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,m){return c.push(u,m),this},this.removeHandler=function(u){let m=c.indexOf(u);return m!==-1&&c.splice(m,2),this},this.getHandler=function(u){for(let m=0,d=c.length;m<d;m+=2){let h=c[m],_=c[m+1];if(h.global&&(h.lastIndex=0),h.test(u))return _}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},gp=new pl,ml=class{constructor(e){this.manager=e!==void 0?e:gp,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};ml.DEFAULT_MATERIAL_NAME="__DEFAULT";var Oo=new V,Bo=new ei,Qn=new V,la=class extends Nn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new lt,this.projectionMatrix=new lt,this.projectionMatrixInverse=new lt,this.coordinateSystem=In,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Oo,Bo,Qn),Qn.x===1&&Qn.y===1&&Qn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Oo,Bo,Qn.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Oo,Bo,Qn),Qn.x===1&&Qn.y===1&&Qn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Oo,Bo,Qn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Hi=new V,Ef=new Ye,Cf=new Ye,an=class extends la{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Ko*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(tu*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Ko*2*Math.atan(Math.tan(tu*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Hi.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Hi.x,Hi.y).multiplyScalar(-e/Hi.z),Hi.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Hi.x,Hi.y).multiplyScalar(-e/Hi.z)}getViewSize(e,t){return this.getViewBounds(e,Ef,Cf),t.subVectors(Cf,Ef)}setViewOffset(e,t,i,s,r,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(tu*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,t-=a.offsetY*i/c,s*=a.width/l,i*=a.height/c}let o=this.filmOffset;o!==0&&(r+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ki=class extends la{constructor(e=-1,t=1,i=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,a=i+e,o=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=u*this.view.offsetY,l=o-u*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var tr=-90,nr=1,ur=class extends Nn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new an(tr,nr,e,t);s.layers=this.layers,this.add(s);let r=new an(tr,nr,e,t);r.layers=this.layers,this.add(r);let a=new an(tr,nr,e,t);a.layers=this.layers,this.add(a);let o=new an(tr,nr,e,t);o.layers=this.layers,this.add(o);let l=new an(tr,nr,e,t);l.layers=this.layers,this.add(l);let c=new an(tr,nr,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,a,o,l]=t;for(let c of t)this.remove(c);if(e===In)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Kr)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,l,c,u]=this.children,m=e.getRenderTarget(),d=e.getActiveCubeFace(),h=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=x,e.setRenderTarget(i,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(m,d,h),e.xr.enabled=_,i.texture.needsPMREMUpdate=!0}},gl=class extends an{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var ih="\\[\\]\\.:\\/",W0=new RegExp("["+ih+"]","g"),sh="[^"+ih+"]",X0="[^"+ih.replace("\\.","")+"]",q0=/((?:WC+[\/:])*)/.source.replace("WC",sh),$0=/(WCOD+)?/.source.replace("WCOD",X0),Y0=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",sh),Z0=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",sh),J0=new RegExp("^"+q0+$0+Y0+Z0+"$"),K0=["material","materials","bones","map"],Au=class{constructor(e,t,i){let s=i||ut.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},ut=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(W0,"")}static parseTrackName(e){let t=J0.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);K0.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===t||o.uuid===t)return o;let l=i(o.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ie("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){Le("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Le("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Le("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Le("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Le("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){Le("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){Le("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let a=e[s];if(a===void 0){let c=t.nodeName;Le("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let o=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?o=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Le("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Le("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};ut.Composite=Au;ut.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};ut.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};ut.prototype.GetterByBindingType=[ut.prototype._getValue_direct,ut.prototype._getValue_array,ut.prototype._getValue_arrayElement,ut.prototype._getValue_toArray];ut.prototype.SetterByBindingTypeAndVersioning=[[ut.prototype._setValue_direct,ut.prototype._setValue_direct_setNeedsUpdate,ut.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[ut.prototype._setValue_array,ut.prototype._setValue_array_setNeedsUpdate,ut.prototype._setValue_array_setMatrixWorldNeedsUpdate],[ut.prototype._setValue_arrayElement,ut.prototype._setValue_arrayElement_setNeedsUpdate,ut.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[ut.prototype._setValue_fromArray,ut.prototype._setValue_fromArray_setNeedsUpdate,ut.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var x1=new Float32Array(1);var Eu=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};function rh(n,e,t,i){let s=Q0(i);switch(t){case $u:return n*e;case Zu:return n*e/s.components*s.byteLength;case Sl:return n*e/s.components*s.byteLength;case ri:return n*e*2/s.components*s.byteLength;case wl:return n*e*2/s.components*s.byteLength;case Yu:return n*e*3/s.components*s.byteLength;case pn:return n*e*4/s.components*s.byteLength;case Tl:return n*e*4/s.components*s.byteLength;case ha:case da:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case fa:case pa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case El:case Rl:return Math.max(n,16)*Math.max(e,8)/4;case Al:case Cl:return Math.max(n,8)*Math.max(e,8)/2;case Pl:case Il:case Nl:case Dl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ll:case ma:case Ul:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Fl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ol:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Bl:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case kl:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case zl:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Vl:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Gl:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Hl:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Wl:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Xl:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case ql:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case $l:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Yl:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Zl:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Jl:case Kl:case Ql:return Math.ceil(n/4)*Math.ceil(e/4)*16;case jl:case ec:return Math.ceil(n/4)*Math.ceil(e/4)*8;case ga:case tc:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Q0(n){switch(n){case jt:case Hu:return{byteLength:1,components:1};case pr:case Wu:case qn:return{byteLength:2,components:1};case bl:case Ml:return{byteLength:2,components:4};case Xn:case yl:case Sn:return{byteLength:4,components:1};case Xu:case qu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ie("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Bp(){let n=null,e=!1,t=null,i=null;function s(r,a){i=n.requestAnimationFrame(s),t(r,a)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function e_(n){let e=new WeakMap;function t(o,l){let c=o.array,u=o.usage,m=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),o.onUploadCallback();let h;if(c instanceof Float32Array)h=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)h=n.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?h=n.HALF_FLOAT:h=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)h=n.SHORT;else if(c instanceof Uint32Array)h=n.UNSIGNED_INT;else if(c instanceof Int32Array)h=n.INT;else if(c instanceof Int8Array)h=n.BYTE;else if(c instanceof Uint8Array)h=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)h=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:h,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:m}}function i(o,l,c){let u=l.array,m=l.updateRanges;if(n.bindBuffer(c,o),m.length===0)n.bufferSubData(c,0,u);else{m.sort((h,_)=>h.start-_.start);let d=0;for(let h=1;h<m.length;h++){let _=m[d],x=m[h];x.start<=_.start+_.count+1?_.count=Math.max(_.count,x.start+x.count-_.start):(++d,m[d]=x)}m.length=d+1;for(let h=0,_=m.length;h<_;h++){let x=m[h];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=e.get(o);l&&(n.deleteBuffer(l.buffer),e.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let u=e.get(o);(!u||u.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let c=e.get(o);if(c===void 0)e.set(o,t(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var t_=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,n_=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,i_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,s_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,r_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,a_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,o_=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,l_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,c_=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,u_=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,h_=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,d_=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,f_=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,p_=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,m_=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,g_=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,__=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,v_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,x_=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,y_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,b_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,M_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,S_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,w_=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,T_=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,A_=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,E_=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,C_=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,R_=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,P_="gl_FragColor = linearToOutputTexel( gl_FragColor );",I_=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,L_=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,N_=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,D_=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,U_=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,F_=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,O_=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,B_=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,k_=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,z_=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,V_=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,G_=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,H_=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,W_=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,X_=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,q_=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,$_=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Y_=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Z_=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,J_=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,K_=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Q_=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,j_=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,ev=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,tv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,nv=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,iv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,sv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,rv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,av=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,ov=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,lv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,cv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,uv=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,hv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,dv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,fv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,pv=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,mv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,gv=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,_v=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,vv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,xv=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,yv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,bv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Mv=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Sv=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,wv=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Tv=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Av=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Ev=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Cv=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Rv=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Pv=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Iv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Lv=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Nv=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Dv=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Uv=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Fv=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Ov=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Bv=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,kv=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,zv=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Vv=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Gv=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Hv=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Wv=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Xv=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,qv=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,$v=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Yv=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Zv=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Jv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Kv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Qv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,jv=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,ex=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,tx=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,nx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ix=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,sx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,rx=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ax=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,ox=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,lx=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,cx=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,ux=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,hx=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,dx=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,fx=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,px=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,mx=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,gx=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,_x=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,vx=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,xx=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,yx=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,bx=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Mx=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Sx=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,wx=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Tx=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ax=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Ex=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Cx=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Rx=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Px=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Ix=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Lx=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Nx=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Ve={alphahash_fragment:t_,alphahash_pars_fragment:n_,alphamap_fragment:i_,alphamap_pars_fragment:s_,alphatest_fragment:r_,alphatest_pars_fragment:a_,aomap_fragment:o_,aomap_pars_fragment:l_,batching_pars_vertex:c_,batching_vertex:u_,begin_vertex:h_,beginnormal_vertex:d_,bsdfs:f_,iridescence_fragment:p_,bumpmap_pars_fragment:m_,clipping_planes_fragment:g_,clipping_planes_pars_fragment:__,clipping_planes_pars_vertex:v_,clipping_planes_vertex:x_,color_fragment:y_,color_pars_fragment:b_,color_pars_vertex:M_,color_vertex:S_,common:w_,defaultnormal_vertex:T_,displacementmap_pars_vertex:A_,displacementmap_vertex:E_,emissivemap_fragment:C_,emissivemap_pars_fragment:R_,colorspace_fragment:P_,colorspace_pars_fragment:I_,envmap_fragment:L_,envmap_common_pars_fragment:N_,envmap_pars_fragment:D_,envmap_pars_vertex:U_,envmap_physical_pars_fragment:q_,envmap_vertex:F_,fog_vertex:O_,fog_pars_vertex:B_,fog_fragment:k_,fog_pars_fragment:z_,gradientmap_pars_fragment:V_,lightmap_pars_fragment:G_,lights_lambert_fragment:H_,lights_lambert_pars_fragment:W_,lights_pars_begin:X_,lights_toon_fragment:$_,lights_toon_pars_fragment:Y_,lights_phong_fragment:Z_,lights_phong_pars_fragment:J_,lights_physical_fragment:K_,lights_physical_pars_fragment:Q_,lights_fragment_begin:j_,lights_fragment_maps:ev,lights_fragment_end:tv,lightprobes_pars_fragment:nv,logdepthbuf_fragment:iv,logdepthbuf_pars_fragment:sv,logdepthbuf_pars_vertex:rv,logdepthbuf_vertex:av,map_fragment:ov,map_pars_fragment:lv,map_particle_fragment:cv,map_particle_pars_fragment:uv,metalnessmap_fragment:hv,metalnessmap_pars_fragment:dv,morphinstance_vertex:fv,morphcolor_vertex:pv,morphnormal_vertex:mv,morphtarget_pars_vertex:gv,morphtarget_vertex:_v,normal_fragment_begin:vv,normal_fragment_maps:xv,normal_pars_fragment:yv,normal_pars_vertex:bv,normal_vertex:Mv,normalmap_pars_fragment:Sv,clearcoat_normal_fragment_begin:wv,clearcoat_normal_fragment_maps:Tv,clearcoat_pars_fragment:Av,iridescence_pars_fragment:Ev,opaque_fragment:Cv,packing:Rv,premultiplied_alpha_fragment:Pv,project_vertex:Iv,dithering_fragment:Lv,dithering_pars_fragment:Nv,roughnessmap_fragment:Dv,roughnessmap_pars_fragment:Uv,shadowmap_pars_fragment:Fv,shadowmap_pars_vertex:Ov,shadowmap_vertex:Bv,shadowmask_pars_fragment:kv,skinbase_vertex:zv,skinning_pars_vertex:Vv,skinning_vertex:Gv,skinnormal_vertex:Hv,specularmap_fragment:Wv,specularmap_pars_fragment:Xv,tonemapping_fragment:qv,tonemapping_pars_fragment:$v,transmission_fragment:Yv,transmission_pars_fragment:Zv,uv_pars_fragment:Jv,uv_pars_vertex:Kv,uv_vertex:Qv,worldpos_vertex:jv,background_vert:ex,background_frag:tx,backgroundCube_vert:nx,backgroundCube_frag:ix,cube_vert:sx,cube_frag:rx,depth_vert:ax,depth_frag:ox,distance_vert:lx,distance_frag:cx,equirect_vert:ux,equirect_frag:hx,linedashed_vert:dx,linedashed_frag:fx,meshbasic_vert:px,meshbasic_frag:mx,meshlambert_vert:gx,meshlambert_frag:_x,meshmatcap_vert:vx,meshmatcap_frag:xx,meshnormal_vert:yx,meshnormal_frag:bx,meshphong_vert:Mx,meshphong_frag:Sx,meshphysical_vert:wx,meshphysical_frag:Tx,meshtoon_vert:Ax,meshtoon_frag:Ex,points_vert:Cx,points_frag:Rx,shadow_vert:Px,shadow_frag:Ix,sprite_vert:Lx,sprite_frag:Nx},pe={common:{diffuse:{value:new Ke(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ne},alphaMap:{value:null},alphaMapTransform:{value:new Ne},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ne}},envmap:{envMap:{value:null},envMapRotation:{value:new Ne},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ne}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ne}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ne},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ne},normalScale:{value:new Ye(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ne},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ne}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ne}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ne}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ke(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ke(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ne},alphaTest:{value:0},uvTransform:{value:new Ne}},sprite:{diffuse:{value:new Ke(16777215)},opacity:{value:1},center:{value:new Ye(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ne},alphaMap:{value:null},alphaMapTransform:{value:new Ne},alphaTest:{value:0}}},oi={basic:{uniforms:en([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.fog]),vertexShader:Ve.meshbasic_vert,fragmentShader:Ve.meshbasic_frag},lambert:{uniforms:en([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,pe.lights,{emissive:{value:new Ke(0)},envMapIntensity:{value:1}}]),vertexShader:Ve.meshlambert_vert,fragmentShader:Ve.meshlambert_frag},phong:{uniforms:en([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,pe.lights,{emissive:{value:new Ke(0)},specular:{value:new Ke(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Ve.meshphong_vert,fragmentShader:Ve.meshphong_frag},standard:{uniforms:en([pe.common,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.roughnessmap,pe.metalnessmap,pe.fog,pe.lights,{emissive:{value:new Ke(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Ve.meshphysical_vert,fragmentShader:Ve.meshphysical_frag},toon:{uniforms:en([pe.common,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.gradientmap,pe.fog,pe.lights,{emissive:{value:new Ke(0)}}]),vertexShader:Ve.meshtoon_vert,fragmentShader:Ve.meshtoon_frag},matcap:{uniforms:en([pe.common,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,{matcap:{value:null}}]),vertexShader:Ve.meshmatcap_vert,fragmentShader:Ve.meshmatcap_frag},points:{uniforms:en([pe.points,pe.fog]),vertexShader:Ve.points_vert,fragmentShader:Ve.points_frag},dashed:{uniforms:en([pe.common,pe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Ve.linedashed_vert,fragmentShader:Ve.linedashed_frag},depth:{uniforms:en([pe.common,pe.displacementmap]),vertexShader:Ve.depth_vert,fragmentShader:Ve.depth_frag},normal:{uniforms:en([pe.common,pe.bumpmap,pe.normalmap,pe.displacementmap,{opacity:{value:1}}]),vertexShader:Ve.meshnormal_vert,fragmentShader:Ve.meshnormal_frag},sprite:{uniforms:en([pe.sprite,pe.fog]),vertexShader:Ve.sprite_vert,fragmentShader:Ve.sprite_frag},background:{uniforms:{uvTransform:{value:new Ne},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Ve.background_vert,fragmentShader:Ve.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ne}},vertexShader:Ve.backgroundCube_vert,fragmentShader:Ve.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Ve.cube_vert,fragmentShader:Ve.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Ve.equirect_vert,fragmentShader:Ve.equirect_frag},distance:{uniforms:en([pe.common,pe.displacementmap,{referencePosition:{value:new V},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Ve.distance_vert,fragmentShader:Ve.distance_frag},shadow:{uniforms:en([pe.lights,pe.fog,{color:{value:new Ke(0)},opacity:{value:1}}]),vertexShader:Ve.shadow_vert,fragmentShader:Ve.shadow_frag}};oi.physical={uniforms:en([oi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ne},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ne},clearcoatNormalScale:{value:new Ye(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ne},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ne},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ne},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ne},sheen:{value:0},sheenColor:{value:new Ke(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ne},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ne},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ne},transmissionSamplerSize:{value:new Ye},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ne},attenuationDistance:{value:0},attenuationColor:{value:new Ke(0)},specularColor:{value:new Ke(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ne},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ne},anisotropyVector:{value:new Ye},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ne}}]),vertexShader:Ve.meshphysical_vert,fragmentShader:Ve.meshphysical_frag};var nc={r:0,b:0,g:0},Dx=new lt,kp=new Ne;kp.set(-1,0,0,0,1,0,0,0,1);function Ux(n,e,t,i,s,r){let a=new Ke(0),o=s===!0?0:1,l,c,u=null,m=0,d=null;function h(M){let A=M.isScene===!0?M.background:null;if(A&&A.isTexture){let S=M.backgroundBlurriness>0;A=e.get(A,S)}return A}function _(M){let A=!1,S=h(M);S===null?p(a,o):S&&S.isColor&&(p(S,1),A=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(M,A){let S=h(A);S&&S.isCubeTexture?(c===void 0&&(c=new qt(new cr(1,1,1),new ni({name:"BackgroundCubeMaterial",uniforms:Es(oi.backgroundCube.uniforms),vertexShader:oi.backgroundCube.vertexShader,fragmentShader:oi.backgroundCube.fragmentShader,side:on,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,E,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Dx.makeRotationFromEuler(A.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(kp),c.material.toneMapped=Xe.getTransfer(S.colorSpace)!==tt,(u!==S||m!==S.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,m=S.version,d=n.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new qt(new aa(2,2),new ni({name:"BackgroundMaterial",uniforms:Es(oi.background.uniforms),vertexShader:oi.background.vertexShader,fragmentShader:oi.background.fragmentShader,side:Qi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=Xe.getTransfer(S.colorSpace)!==tt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||m!==S.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,m=S.version,d=n.toneMapping),l.layers.enableAll(),M.unshift(l,l.geometry,l.material,0,0,null))}function p(M,A){M.getRGB(nc,nh(n)),t.buffers.color.setClear(nc.r,nc.g,nc.b,A,r)}function f(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(M,A=1){a.set(M),o=A,p(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(M){o=M,p(a,o)},render:_,addToRenderList:x,dispose:f}}function Fx(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,a=!1;function o(D,k,H,I,q){let K=!1,G=m(D,I,H,k);r!==G&&(r=G,c(r.object)),K=h(D,I,H,q),K&&_(D,I,H,q),q!==null&&e.update(q,n.ELEMENT_ARRAY_BUFFER),(K||a)&&(a=!1,S(D,k,H,I),q!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(q).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function u(D){return n.deleteVertexArray(D)}function m(D,k,H,I){let q=I.wireframe===!0,K=i[k.id];K===void 0&&(K={},i[k.id]=K);let G=D.isInstancedMesh===!0?D.id:0,ne=K[G];ne===void 0&&(ne={},K[G]=ne);let X=ne[H.id];X===void 0&&(X={},ne[H.id]=X);let j=X[q];return j===void 0&&(j=d(l()),X[q]=j),j}function d(D){let k=[],H=[],I=[];for(let q=0;q<t;q++)k[q]=0,H[q]=0,I[q]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:H,attributeDivisors:I,object:D,attributes:{},index:null}}function h(D,k,H,I){let q=r.attributes,K=k.attributes,G=0,ne=H.getAttributes();for(let X in ne)if(ne[X].location>=0){let ee=q[X],Me=K[X];if(Me===void 0&&(X==="instanceMatrix"&&D.instanceMatrix&&(Me=D.instanceMatrix),X==="instanceColor"&&D.instanceColor&&(Me=D.instanceColor)),ee===void 0||ee.attribute!==Me||Me&&ee.data!==Me.data)return!0;G++}return r.attributesNum!==G||r.index!==I}function _(D,k,H,I){let q={},K=k.attributes,G=0,ne=H.getAttributes();for(let X in ne)if(ne[X].location>=0){let ee=K[X];ee===void 0&&(X==="instanceMatrix"&&D.instanceMatrix&&(ee=D.instanceMatrix),X==="instanceColor"&&D.instanceColor&&(ee=D.instanceColor));let Me={};Me.attribute=ee,ee&&ee.data&&(Me.data=ee.data),q[X]=Me,G++}r.attributes=q,r.attributesNum=G,r.index=I}function x(){let D=r.newAttributes;for(let k=0,H=D.length;k<H;k++)D[k]=0}function p(D){f(D,0)}function f(D,k){let H=r.newAttributes,I=r.enabledAttributes,q=r.attributeDivisors;H[D]=1,I[D]===0&&(n.enableVertexAttribArray(D),I[D]=1),q[D]!==k&&(n.vertexAttribDivisor(D,k),q[D]=k)}function M(){let D=r.newAttributes,k=r.enabledAttributes;for(let H=0,I=k.length;H<I;H++)k[H]!==D[H]&&(n.disableVertexAttribArray(H),k[H]=0)}function A(D,k,H,I,q,K,G){G===!0?n.vertexAttribIPointer(D,k,H,q,K):n.vertexAttribPointer(D,k,H,I,q,K)}function S(D,k,H,I){x();let q=I.attributes,K=H.getAttributes(),G=k.defaultAttributeValues;for(let ne in K){let X=K[ne];if(X.location>=0){let j=q[ne];if(j===void 0&&(ne==="instanceMatrix"&&D.instanceMatrix&&(j=D.instanceMatrix),ne==="instanceColor"&&D.instanceColor&&(j=D.instanceColor)),j!==void 0){let ee=j.normalized,Me=j.itemSize,Ue=e.get(j);if(Ue===void 0)continue;let Z=Ue.buffer,me=Ue.type,xe=Ue.bytesPerElement,Ee=me===n.INT||me===n.UNSIGNED_INT||j.gpuType===yl;if(j.isInterleavedBufferAttribute){let ge=j.data,Oe=ge.isInterleavedBuffer===!0?ge.stride:ge.itemSize,Mt=j.offset;if(ge.isInstancedInterleavedBuffer||ge.isInstancedBufferAttribute){for(let Re=0;Re<X.locationSize;Re++)f(X.location+Re,ge.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=ge.meshPerAttribute*ge.count)}else for(let Re=0;Re<X.locationSize;Re++)p(X.location+Re);n.bindBuffer(n.ARRAY_BUFFER,Z);for(let Re=0;Re<X.locationSize;Re++)A(X.location+Re,Me/X.locationSize,me,ee,Oe*xe,(Mt+Me/X.locationSize*Re)*xe,Ee)}else{if(j.isInstancedBufferAttribute){for(let ge=0;ge<X.locationSize;ge++)f(X.location+ge,j.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let ge=0;ge<X.locationSize;ge++)p(X.location+ge);n.bindBuffer(n.ARRAY_BUFFER,Z);for(let ge=0;ge<X.locationSize;ge++)A(X.location+ge,Me/X.locationSize,me,ee,Me*xe,Me/X.locationSize*ge*xe,Ee)}}else if(G!==void 0){let ee=G[ne];if(ee!==void 0)switch(ee.length){case 2:n.vertexAttrib2fv(X.location,ee);break;case 3:n.vertexAttrib3fv(X.location,ee);break;case 4:n.vertexAttrib4fv(X.location,ee);break;default:n.vertexAttrib1fv(X.location,ee)}}}}M()}function C(){B();for(let D in i){let k=i[D];for(let H in k){let I=k[H];for(let q in I){let K=I[q];for(let G in K)u(K[G].object),delete K[G];delete I[q]}}delete i[D]}}function E(D){if(i[D.id]===void 0)return;let k=i[D.id];for(let H in k){let I=k[H];for(let q in I){let K=I[q];for(let G in K)u(K[G].object),delete K[G];delete I[q]}}delete i[D.id]}function v(D){for(let k in i){let H=i[k];for(let I in H){let q=H[I];if(q[D.id]===void 0)continue;let K=q[D.id];for(let G in K)u(K[G].object),delete K[G];delete q[D.id]}}}function w(D){for(let k in i){let H=i[k],I=D.isInstancedMesh===!0?D.id:0,q=H[I];if(q!==void 0){for(let K in q){let G=q[K];for(let ne in G)u(G[ne].object),delete G[ne];delete q[K]}delete H[I],Object.keys(H).length===0&&delete i[k]}}}function B(){L(),a=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:B,resetDefaultState:L,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:w,releaseStatesOfProgram:v,initAttributes:x,enableAttribute:p,disableUnusedAttributes:M}}function Ox(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function a(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function o(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let h=0;h<u;h++)d+=c[h];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function Bx(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(v){return!(v!==pn&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(v){let w=v===qn&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==jt&&v!==Sn&&!w&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ie("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let m=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&m===!1;t.reversedDepthBuffer===!0&&m===!1&&Ie("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&m===!0&&Ie("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let h=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),f=n.getParameter(n.MAX_VERTEX_ATTRIBS),M=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:m,maxTextures:h,maxVertexTextures:_,maxTextureSize:x,maxCubemapSize:p,maxAttributes:f,maxVertexUniforms:M,maxVaryings:A,maxFragmentUniforms:S,maxSamples:C,samples:E}}function kx(n){let e=this,t=null,i=0,s=!1,r=!1,a=new Wn,o=new Ne,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(m,d){let h=m.length!==0||d||i!==0||s;return s=d,i=m.length,h},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(m,d){t=u(m,d,0)},this.setState=function(m,d,h){let _=m.clippingPlanes,x=m.clipIntersection,p=m.clipShadows,f=n.get(m);if(!s||_===null||_.length===0||r&&!p)r?u(null):c();else{let M=r?0:i,A=M*4,S=f.clippingState||null;l.value=S,S=u(_,d,A,h);for(let C=0;C!==A;++C)S[C]=t[C];f.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(m,d,h,_){let x=m!==null?m.length:0,p=null;if(x!==0){if(p=l.value,_!==!0||p===null){let f=h+x*4,M=d.matrixWorldInverse;o.getNormalMatrix(M),(p===null||p.length<f)&&(p=new Float32Array(f));for(let A=0,S=h;A!==x;++A,S+=4)a.copy(m[A]).applyMatrix4(M,o),a.normal.toArray(p,S),p[S+3]=a.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,p}}var ya=class extends Gt{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new ia(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new cr(5,5,5),r=new ni({name:"CubemapFromEquirect",uniforms:Es(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:on,blending:Ss});r.uniforms.tEquirect.value=t;let a=new qt(s,r),o=t.minFilter;return t.minFilter===Ai&&(t.minFilter=mt),new ur(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,i,s);e.setRenderTarget(r)}},_p=256,zx=3,Vx=20,zp=256,Vp=16,Gx=3,Hx=new V,Wx=new Ke,sc=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ur(1,10,null),this._boxMesh=new qt(new cr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:a=256,position:o=Hx}=r,l=this._renderer;this._setSize(a);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let m=l.autoClear,d=l.autoClearColor,h=l.autoClearDepth,_=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(Wx));let p=new ur(i,s,u);return p.position.copy(o),p.update(l,e),l.autoClear=m,l.autoClearColor=d,l.autoClearDepth=h,l.autoClearStencil=_,e.background=x,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=yp(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=xp(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(_p,dp(e))}_fromTexture(e,t){e.mapping===Ts||e.mapping===fr?this._setSize(e.image.length===0?_p:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=vp(e,!1,!1),i=Math.log2(e)-zx;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=vp(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Ts||e.mapping===fr?(this._cubemapMaterial===null&&(this._cubemapMaterial=yp()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=xp()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=Xx(),this._integrationMaterial=qx());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Vp);for(let a=0;a<=i;a++){let o=n.lodToRoughness(a,i);if(a>i-Gx)r.roughness.value=o,this._renderCube(e,a,this._integrationMaterial);else{let l=o>0?Math.log2(t)+.5*Math.log2(6/(zp*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=$x());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function vp(n,e,t){return new ya(n,{minFilter:Ai,generateMipmaps:e,type:qn,colorSpace:Zr,depthBuffer:t})}function ba(n,e,t){return new ni({name:n,uniforms:e,vertexShader:Ve.cube_vert,fragmentShader:t,side:on,blending:Ss,depthTest:!1,depthWrite:!1})}function Xx(){return ba("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${zp}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function qx(){return ba("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Vp}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function $x(){return ba("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Vx}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function xp(){return ba("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function yp(){return ba("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Yx(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,h=!1){return d==null?null:h?a(d):r(d)}function r(d){if(d&&d.isTexture){let h=d.mapping;if(h===_l||h===vl)if(e.has(d)){let _=e.get(d).texture;return o(_,d.mapping)}else{let _=d.image;if(_&&_.height>0){let x=new ya(_.height);return x.fromEquirectangularTexture(n,d),e.set(d,x),d.addEventListener("dispose",c),o(x.texture,d.mapping)}else return null}}return d}function a(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let h=d.mapping,_=h===_l||h===vl,x=h===Ts||h===fr;if(_||x){let p=t.get(d),f=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==f)return i===null&&(i=new sc(n)),p=_?i.fromEquirectangular(d,p):i.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),p.texture;if(p!==void 0)return p.texture;{let M=d.image;return _&&M&&M.height>0||x&&M&&l(M)?(i===null&&(i=new sc(n)),p=_?i.fromEquirectangular(d):i.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),d.addEventListener("dispose",u),p.texture):null}}}return d}function o(d,h){return h===_l?d.mapping=Ts:h===vl&&(d.mapping=fr),d}function l(d){let h=0,_=6;for(let x=0;x<_;x++)d[x]!==void 0&&h++;return h===_}function c(d){let h=d.target;h.removeEventListener("dispose",c);let _=e.get(h);_!==void 0&&(e.delete(h),_.dispose())}function u(d){let h=d.target;h.removeEventListener("dispose",u);let _=t.get(h);_!==void 0&&(t.delete(h),_.dispose())}function m(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:m}}function Zx(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&$r("WebGLRenderer: "+i+" extension not supported."),s}}}function Jx(n,e,t,i){let s={},r=new WeakMap,a=new FinalizationRegistry(_=>delete s[_]);function o(_){l(_.target)}function l(_){_.index!==null&&e.remove(_.index);for(let p in _.attributes)e.remove(_.attributes[p]);_.removeEventListener("dispose",o),delete s[_.id],a.unregister(_);let x=r.get(_);x&&(e.remove(x),r.delete(_)),i.releaseStatesOfGeometry(_),_.isInstancedBufferGeometry===!0&&delete _._maxInstanceCount,t.memory.geometries--}function c(_,x){return s[x.id]!==void 0||(x.addEventListener("dispose",o),s[x.id]=new WeakRef(x),a.register(x,x.id,x),t.memory.geometries++),x}function u(_){let x=_.attributes;for(let p in x)e.update(x[p],n.ARRAY_BUFFER)}function m(_){let x=_.index,p=_.attributes.position,f=0;if(p===void 0)return;let M=x!==null?x.array.length:p.array.length/3-1,A=p.count>=65535?na:ta,S=new A(Math.ceil(M/3)*6,1),C=S.array;if(x!==null){let v=x.array;f=x.version;for(let w=0,B=0;w<M;w+=3){let L=v[w+0],D=v[w+1],k=v[w+2];C[B++]=L,C[B++]=D,C[B++]=D,C[B++]=k,C[B++]=k,C[B++]=L}}else{f=p.version;for(let v=0,w=0;v<M;v+=3){let B=v+0,L=v+1,D=v+2;C[w++]=B,C[w++]=L,C[w++]=L,C[w++]=D,C[w++]=D,C[w++]=B}}S.version=f;let E=r.get(_);E&&e.remove(E),r.set(_,S)}function d(_){let x=r.get(_);if(x){let p=_.index;p!==null&&x.version<p.version&&m(_)}else m(_);return r.get(_)}function h(){for(let _ in s){let x=s[_].deref();x!==void 0&&l(x)}}return{get:c,update:u,getWireframeAttribute:d,dispose:h}}function Kx(n,e,t){let i;function s(m){i=m}let r,a;function o(m){r=m.type,a=m.bytesPerElement}function l(m,d){n.drawElements(i,d,r,m*a),t.update(d,i,1)}function c(m,d,h){h!==0&&(n.drawElementsInstanced(i,d,r,m*a,h),t.update(d,i,h))}function u(m,d,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,m,0,h);let x=0;for(let p=0;p<h;p++)x+=d[p];t.update(x,i,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function Qx(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,a,o){switch(t.calls++,a){case n.TRIANGLES:t.triangles+=o*(r/3);break;case n.LINES:t.lines+=o*(r/2);break;case n.LINE_STRIP:t.lines+=o*(r-1);break;case n.LINE_LOOP:t.lines+=o*r;break;case n.POINTS:t.points+=o*r;break;default:Le("WebGLInfo: Unknown draw mode:",a);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function jx(n,e,t){let i=new WeakMap,s=new xt;function r(a,o,l){let c=a.morphTargetInfluences,u=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,m=u!==void 0?u.length:0,d=i.get(o);if(d===void 0||d.count!==m){let B=function(){v.dispose(),i.delete(o),o.removeEventListener("dispose",B)};d!==void 0&&d.texture.dispose();let h=o.morphAttributes.position!==void 0,_=o.morphAttributes.normal!==void 0,x=o.morphAttributes.color!==void 0,p=o.morphAttributes.position||[],f=o.morphAttributes.normal||[],M=o.morphAttributes.color||[],A=0;h===!0&&(A=1),_===!0&&(A=2),x===!0&&(A=3);let S=o.attributes.position.count*A,C=1;S>e.maxTextureSize&&(C=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let E=new Float32Array(S*C*4*m),v=new jr(E,S,C,m);v.type=Sn,v.needsUpdate=!0;let w=A*4;for(let L=0;L<m;L++){let D=p[L],k=f[L],H=M[L],I=S*C*4*L;for(let q=0;q<D.count;q++){let K=q*w;h===!0&&(s.fromBufferAttribute(D,q),E[I+K+0]=s.x,E[I+K+1]=s.y,E[I+K+2]=s.z,E[I+K+3]=0),_===!0&&(s.fromBufferAttribute(k,q),E[I+K+4]=s.x,E[I+K+5]=s.y,E[I+K+6]=s.z,E[I+K+7]=0),x===!0&&(s.fromBufferAttribute(H,q),E[I+K+8]=s.x,E[I+K+9]=s.y,E[I+K+10]=s.z,E[I+K+11]=H.itemSize===4?s.w:1)}}d={count:m,texture:v,size:new Ye(S,C)},i.set(o,d),o.addEventListener("dispose",B)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",a.morphTexture,t);else{let h=0;for(let x=0;x<c.length;x++)h+=c[x];let _=o.morphTargetsRelative?1:1-h;l.getUniforms().setValue(n,"morphTargetBaseInfluence",_),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function ey(n,e,t,i,s){let r=new WeakMap;function a(c){let u=s.render.frame,m=c.geometry,d=e.get(c,m);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let h=c.skeleton;r.get(h)!==u&&(h.update(),r.set(h,u))}return d}function o(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:a,dispose:o}}var ty={[Uu]:"LINEAR_TONE_MAPPING",[Fu]:"REINHARD_TONE_MAPPING",[Ou]:"CINEON_TONE_MAPPING",[Bu]:"ACES_FILMIC_TONE_MAPPING",[zu]:"AGX_TONE_MAPPING",[Vu]:"NEUTRAL_TONE_MAPPING",[ku]:"CUSTOM_TONE_MAPPING"};function ny(n,e,t,i,s,r){let a=new Gt(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,c=null,u=new ti;u.setAttribute("position",new Ln([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Ln([0,2,0,0,2,0],2));let m=new ii({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new qt(u,m),h=new Ki(-1,1,1,-1,0,1),_=null,x=null,p=!1,f,M=null,A=[],S=!1;this.setSize=function(C,E){a.setSize(C,E),o!==null&&o.setSize(C,E),l!==null&&l.setSize(C,E);for(let v=0;v<A.length;v++){let w=A[v];w.setSize&&w.setSize(C,E)}},this.setEffects=function(C){A=C,S=A.length>0&&A[0].isRenderPass===!0;let E=a.width,v=a.height;A.length>0&&o===null&&(o=new Gt(E,v,{type:qn,depthBuffer:!1,stencilBuffer:!1}),l=new Gt(E,v,{type:qn,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&A.some(B=>B.needsDepthTexture===!0);w!==(a.depthTexture!==null)&&(w===!0&&c===null&&(c=new Ti(E,v),r===!0&&(c.format=Ei,c.type=As)),a.dispose(),a.depthTexture=w?c:null,a.resolveDepthBuffer=w,a.storeMultisampledDepthBuffer=w);for(let B=0;B<A.length;B++){let L=A[B];L.setSize&&L.setSize(E,v),w&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(C,E){if(p||C.toneMapping===si&&A.length===0)return!1;if(M=E,E!==null){let v=E.width,w=E.height;(a.width!==v||a.height!==w)&&this.setSize(v,w)}return S===!1&&C.setRenderTarget(a),f=C.toneMapping,C.toneMapping=si,!0},this.hasRenderPass=function(){return S},this.end=function(C,E){C.toneMapping=f,p=!0;let v=a,w=o;for(let B=0;B<A.length;B++){let L=A[B];L.enabled!==!1&&(L.render(C,w,v,E),L.needsSwap!==!1&&(v=w,w=w===o?l:o))}if(_!==C.outputColorSpace||x!==C.toneMapping){_=C.outputColorSpace,x=C.toneMapping,m.defines={},Xe.getTransfer(_)===tt&&(m.defines.SRGB_TRANSFER="");let B=ty[x];B&&(m.defines[B]=""),m.needsUpdate=!0}m.uniforms.tDiffuse.value=v.texture,C.setRenderTarget(M),C.render(d,h),M=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),u.dispose(),m.dispose()}}var Gp=new fn,Hp=new Ti(1,1),Wp=new sa(1),Xp=new jr,qp=new el,$p=new ia,bp=[],Mp=[],Sp=new Float32Array(16),wp=new Float32Array(9),Tp=new Float32Array(4);function gr(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=bp[s];if(r===void 0&&(r=new Float32Array(s),bp[s]=r),e!==0){i.toArray(r,0);for(let a=1,o=0;a!==e;++a)o+=t,n[a].toArray(r,o)}return r}function Dt(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Ut(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function ac(n,e){let t=Mp[e];t===void 0&&(t=new Int32Array(e),Mp[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function iy(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function sy(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Dt(t,e))return;n.uniform2fv(this.addr,e),Ut(t,e)}}function ry(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Dt(t,e))return;n.uniform3fv(this.addr,e),Ut(t,e)}}function ay(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Dt(t,e))return;n.uniform4fv(this.addr,e),Ut(t,e)}}function oy(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Dt(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Ut(t,e)}else{if(Dt(t,i))return;Tp.set(i),n.uniformMatrix2fv(this.addr,!1,Tp),Ut(t,i)}}function ly(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Dt(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Ut(t,e)}else{if(Dt(t,i))return;wp.set(i),n.uniformMatrix3fv(this.addr,!1,wp),Ut(t,i)}}function cy(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Dt(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Ut(t,e)}else{if(Dt(t,i))return;Sp.set(i),n.uniformMatrix4fv(this.addr,!1,Sp),Ut(t,i)}}function uy(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function hy(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Dt(t,e))return;n.uniform2iv(this.addr,e),Ut(t,e)}}function dy(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Dt(t,e))return;n.uniform3iv(this.addr,e),Ut(t,e)}}function fy(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Dt(t,e))return;n.uniform4iv(this.addr,e),Ut(t,e)}}function py(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function my(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Dt(t,e))return;n.uniform2uiv(this.addr,e),Ut(t,e)}}function gy(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Dt(t,e))return;n.uniform3uiv(this.addr,e),Ut(t,e)}}function _y(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Dt(t,e))return;n.uniform4uiv(this.addr,e),Ut(t,e)}}function oc(n){return n.version===0&&(n.compareFunction=ju,n.needsUpdate=!0),n}function vy(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=oc(Hp):r=Gp,t.setTexture2D(e||r,s)}function xy(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||qp,s)}function yy(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=oc(Wp):r=$p,t.setTextureCube(e||r,s)}function by(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Xp,s)}function My(n){switch(n){case 5126:return iy;case 35664:return sy;case 35665:return ry;case 35666:return ay;case 35674:return oy;case 35675:return ly;case 35676:return cy;case 5124:case 35670:return uy;case 35667:case 35671:return hy;case 35668:case 35672:return dy;case 35669:case 35673:return fy;case 5125:return py;case 36294:return my;case 36295:return gy;case 36296:return _y;case 35678:case 36198:case 36298:case 36306:case 35682:return vy;case 35679:case 36299:case 36307:return xy;case 35680:case 36300:case 36308:case 36293:return yy;case 36289:case 36303:case 36311:case 36292:return by}}function Sy(n,e){n.uniform1fv(this.addr,e)}function wy(n,e){let t=gr(e,this.size,2);n.uniform2fv(this.addr,t)}function Ty(n,e){let t=gr(e,this.size,3);n.uniform3fv(this.addr,t)}function Ay(n,e){let t=gr(e,this.size,4);n.uniform4fv(this.addr,t)}function Ey(n,e){let t=gr(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function Cy(n,e){let t=gr(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function Ry(n,e){let t=gr(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function Py(n,e){n.uniform1iv(this.addr,e)}function Iy(n,e){n.uniform2iv(this.addr,e)}function Ly(n,e){n.uniform3iv(this.addr,e)}function Ny(n,e){n.uniform4iv(this.addr,e)}function Dy(n,e){n.uniform1uiv(this.addr,e)}function Uy(n,e){n.uniform2uiv(this.addr,e)}function Fy(n,e){n.uniform3uiv(this.addr,e)}function Oy(n,e){n.uniform4uiv(this.addr,e)}function By(n,e,t){let i=this.cache,s=e.length,r=ac(t,s);Dt(i,r)||(n.uniform1iv(this.addr,r),Ut(i,r));let a;this.type===n.SAMPLER_2D_SHADOW?a=oc(Hp):a=Gp;for(let o=0;o!==s;++o)t.setTexture2D(e[o]||a,r[o])}function ky(n,e,t){let i=this.cache,s=e.length,r=ac(t,s);Dt(i,r)||(n.uniform1iv(this.addr,r),Ut(i,r));for(let a=0;a!==s;++a)t.setTexture3D(e[a]||qp,r[a])}function zy(n,e,t){let i=this.cache,s=e.length,r=ac(t,s);Dt(i,r)||(n.uniform1iv(this.addr,r),Ut(i,r));let a;this.type===n.SAMPLER_CUBE_SHADOW?a=oc(Wp):a=$p;for(let o=0;o!==s;++o)t.setTextureCube(e[o]||a,r[o])}function Vy(n,e,t){let i=this.cache,s=e.length,r=ac(t,s);Dt(i,r)||(n.uniform1iv(this.addr,r),Ut(i,r));for(let a=0;a!==s;++a)t.setTexture2DArray(e[a]||Xp,r[a])}function Gy(n){switch(n){case 5126:return Sy;case 35664:return wy;case 35665:return Ty;case 35666:return Ay;case 35674:return Ey;case 35675:return Cy;case 35676:return Ry;case 5124:case 35670:return Py;case 35667:case 35671:return Iy;case 35668:case 35672:return Ly;case 35669:case 35673:return Ny;case 5125:return Dy;case 36294:return Uy;case 36295:return Fy;case 36296:return Oy;case 35678:case 36198:case 36298:case 36306:case 35682:return By;case 35679:case 36299:case 36307:return ky;case 35680:case 36300:case 36308:case 36293:return zy;case 36289:case 36303:case 36311:case 36292:return Vy}}var lh=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=My(t.type)}},ch=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Gy(t.type)}},uh=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(e,t[o.id],i)}}},ah=/(\w+)(\])?(\[|\.)?/g;function Ap(n,e){n.seq.push(e),n.map[e.id]=e}function Hy(n,e,t){let i=n.name,s=i.length;for(ah.lastIndex=0;;){let r=ah.exec(i),a=ah.lastIndex,o=r[1],l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){Ap(t,c===void 0?new lh(o,n,e):new ch(o,n,e));break}else{let m=t.map[o];m===void 0&&(m=new uh(o),Ap(t,m)),t=m}}}var mr=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<i;++a){let o=e.getActiveUniform(t,a),l=e.getUniformLocation(t,o.name);Hy(o,l,this)}let s=[],r=[];for(let a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,a=t.length;r!==a;++r){let o=t[r],l=i[o.id];l.needsUpdate!==!1&&o.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let a=e[s];a.id in t&&i.push(a)}return i}};function Ep(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var Wy=37297,Xy=0;function qy(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let a=s;a<r;a++){let o=a+1;i.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return i.join(`
`)}var Cp=new Ne;function $y(n){Xe._getMatrix(Cp,Xe.workingColorSpace,n);let e=`mat3( ${Cp.elements.map(t=>t.toFixed(4))} )`;switch(Xe.getTransfer(n)){case Jr:return[e,"LinearTransferOETF"];case tt:return[e,"sRGBTransferOETF"];default:return Ie("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Rp(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return t.toUpperCase()+`

`+r+`

`+qy(n.getShaderSource(e),o)}else return r}function Yy(n,e){let t=$y(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Zy={[Uu]:"Linear",[Fu]:"Reinhard",[Ou]:"Cineon",[Bu]:"ACESFilmic",[zu]:"AgX",[Vu]:"Neutral",[ku]:"Custom"};function Jy(n,e){let t=Zy[e];return t===void 0?(Ie("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var ic=new V;function Ky(){Xe.getLuminanceCoefficients(ic);let n=ic.x.toFixed(4),e=ic.y.toFixed(4),t=ic.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Qy(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(xa).join(`
`)}function jy(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function eb(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),a=r.name,o=1;r.type===n.FLOAT_MAT2&&(o=2),r.type===n.FLOAT_MAT3&&(o=3),r.type===n.FLOAT_MAT4&&(o=4),t[a]={type:r.type,location:n.getAttribLocation(e,a),locationSize:o}}return t}function xa(n){return n!==""}function Pp(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Ip(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var tb=/^[ \t]*#include +<([\w\d./]+)>/gm;function hh(n){return n.replace(tb,nb)}function nb(n,e){let t=Ve[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return hh(t)}var ib=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Lp(n){return n.replace(ib,sb)}function sb(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Np(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var rb={[ca]:"SHADOWMAP_TYPE_PCF",[hr]:"SHADOWMAP_TYPE_VSM"};function ab(n){return rb[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var ob={[fr]:"ENVMAP_MODE_REFRACTION"};function lb(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":ob[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var cb={[Du]:"ENVMAP_BLENDING_MULTIPLY",[Jf]:"ENVMAP_BLENDING_MIX",[Kf]:"ENVMAP_BLENDING_ADD"};function ub(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":cb[n.combine]||"ENVMAP_BLENDING_NONE"}function hb(n,e,t,i){let s=n.getContext(),r=t.defines,a=t.vertexShader,o=t.fragmentShader,l=ab(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=lb(t),m=ub(t),d=Qy(t),h=jy(r),_=s.createProgram(),x,p,f=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,h].filter(xa).join(`
`),x.length>0&&(x+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,h].filter(xa).join(`
`),p.length>0&&(p+=`
`)):(x=[Np(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,h,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(xa).join(`
`),p=[Np(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,h,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+m:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==si?"#define TONE_MAPPING":"",t.toneMapping!==si?Ve.tonemapping_pars_fragment:"",t.toneMapping!==si?Jy("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",Ve.colorspace_pars_fragment,Yy("linearToOutputTexel",t.outputColorSpace),Ky(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(xa).join(`
`)),a=hh(a),a=Pp(a,t),a=Ip(a,t),o=hh(o),o=Pp(o,t),o=Ip(o,t),a=Lp(a),o=Lp(o),t.isRawShaderMaterial!==!0&&(f=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,p=["#define varying in",t.glslVersion===Ri?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Ri?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let M=f+x+a,A=f+p+o,S=Ep(s,s.VERTEX_SHADER,M),C=Ep(s,s.FRAGMENT_SHADER,A);s.attachShader(_,S),s.attachShader(_,C),t.index0AttributeName!==void 0?s.bindAttribLocation(_,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function E(L){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(_)||"",k=s.getShaderInfoLog(S)||"",H=s.getShaderInfoLog(C)||"",I=D.trim(),q=k.trim(),K=H.trim(),G=!0,ne=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,_,S,C);else{let X=Rp(s,S,"vertex"),j=Rp(s,C,"fragment");Le("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+I+`
`+X+`
`+j)}else I!==""?Ie("WebGLProgram: Program Info Log:",I):(q===""||K==="")&&(ne=!1);ne&&(L.diagnostics={runnable:G,programLog:I,vertexShader:{log:q,prefix:x},fragmentShader:{log:K,prefix:p}})}s.deleteShader(S),s.deleteShader(C),v=new mr(s,_),w=eb(s,_)}let v;this.getUniforms=function(){return v===void 0&&E(this),v};let w;this.getAttributes=function(){return w===void 0&&E(this),w};let B=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=s.getProgramParameter(_,Wy)),B},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Xy++,this.cacheKey=e,this.usedTimes=1,this.program=_,this.vertexShader=S,this.fragmentShader=C,this}var db=0,dh=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new fh(e),t.set(e,i)),i}},fh=class{constructor(e){this.id=db++,this.code=e,this.usedTimes=0}};function fb(n){return n===ri||n===ma||n===ga}function pb(n,e,t,i,s,r){let a=new ea,o=new dh,l=new Set,c=[],u=new Map,m=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function h(v){return l.add(v),v===0?"uv":`uv${v}`}function _(v,w,B,L,D,k){let H=L.fog,I=D.geometry,q=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?L.environment:null,K=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,G=e.get(v.envMap||q,K),ne=d[v.type],X=i.precision;v.precision!==null&&(X=i.getMaxPrecision(v.precision),X!==v.precision&&Ie("WebGLProgram.getParameters:",v.precision,"not supported, using",X,"instead."));let j=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,ee=j!==void 0?j.length:0,Me=0;I.morphAttributes.position!==void 0&&(Me=1),I.morphAttributes.normal!==void 0&&(Me=2),I.morphAttributes.color!==void 0&&(Me=3);let Ue,Z,me,xe;if(ne){let fe=oi[ne];Ue=fe.vertexShader,Z=fe.fragmentShader}else{Ue=v.vertexShader,Z=v.fragmentShader;let fe=o.getVertexShaderStage(v),it=o.getFragmentShaderStage(v);o.update(v,fe,it),me=fe.id,xe=it.id}let Ee=n.getRenderTarget(),ge=n.state.buffers.depth.getReversed(),Oe=D.isInstancedMesh===!0,Mt=D.isBatchedMesh===!0,Re=!!v.map,nt=!!v.matcap,at=!!G,Ge=at&&G.isPMREMTexture===!0,Ht=!!v.aoMap,Ct=!!v.lightMap,ln=!!v.bumpMap&&v.wireframe===!1,gt=!!v.normalMap,$n=!!v.displacementMap,Ft=!!v.emissiveMap,wn=!!v.metalnessMap,Tn=!!v.roughnessMap,An=v.anisotropy>0,N=v.clearcoat>0,En=v.diffuseRoughness>0,ht=v.dispersion>0,dt=v.retroreflectivity>0,de=v.iridescence>0,Rt=v.sheen>0,Ce=v.transmission>0,De=An&&!!v.anisotropyMap,T=N&&!!v.clearcoatMap,y=N&&!!v.clearcoatNormalMap,F=N&&!!v.clearcoatRoughnessMap,te=En&&!!v.diffuseRoughnessMap,Q=de&&!!v.iridescenceMap,re=de&&!!v.iridescenceThicknessMap,ue=Rt&&!!v.sheenColorMap,$=Rt&&!!v.sheenRoughnessMap,Y=!!v.specularMap,oe=!!v.specularColorMap,R=!!v.specularIntensityMap,J=Ce&&!!v.transmissionMap,W=Ce&&!!v.thicknessMap,le=!!v.gradientMap,se=!!v.alphaMap,ae=v.alphaTest>0,we=!!v.alphaHash,ze=!!v.extensions,ie=si;v.toneMapped&&(Ee===null||Ee.isXRRenderTarget===!0)&&(ie=n.toneMapping);let Ae=Ge?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Be={shaderID:ne,shaderType:v.type,shaderName:v.name,vertexShader:Ue,fragmentShader:Z,defines:v.defines,customVertexShaderID:me,customFragmentShaderID:xe,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:X,batching:Mt,batchingColor:Mt&&D._colorsTexture!==null,instancing:Oe,instancingColor:Oe&&D.instanceColor!==null,instancingMorph:Oe&&D.morphTexture!==null,outputColorSpace:Ee===null?n.outputColorSpace:Ee.isXRRenderTarget===!0?Ee.texture.colorSpace:Xe.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Re,matcap:nt,envMap:at,envMapMode:at&&G.mapping,envMapPMREM:Ge,envMapMaxLod:Ge?Ae.length-1:null,envMapSize:Ge?Ae[0].width:null,aoMap:Ht,lightMap:Ct,bumpMap:ln,normalMap:gt,displacementMap:$n,emissiveMap:Ft,normalMapObjectSpace:gt&&v.normalMapType===ep,normalMapTangentSpace:gt&&v.normalMapType===Ju,packedNormalMap:gt&&v.normalMapType===Ju&&fb(v.normalMap.format),metalnessMap:wn,roughnessMap:Tn,anisotropy:An,anisotropyMap:De,clearcoat:N,clearcoatMap:T,clearcoatNormalMap:y,clearcoatRoughnessMap:F,diffuseRoughness:En,diffuseRoughnessMap:te,dispersion:ht,retroreflection:dt,iridescence:de,iridescenceMap:Q,iridescenceThicknessMap:re,sheen:Rt,sheenColorMap:ue,sheenRoughnessMap:$,specularMap:Y,specularColorMap:oe,specularIntensityMap:R,transmission:Ce,transmissionMap:J,thicknessMap:W,gradientMap:le,opaque:v.transparent===!1&&v.blending===dr&&v.alphaToCoverage===!1,alphaMap:se,alphaTest:ae,alphaHash:we,combine:v.combine,mapUv:Re&&h(v.map.channel),aoMapUv:Ht&&h(v.aoMap.channel),lightMapUv:Ct&&h(v.lightMap.channel),bumpMapUv:ln&&h(v.bumpMap.channel),normalMapUv:gt&&h(v.normalMap.channel),displacementMapUv:$n&&h(v.displacementMap.channel),emissiveMapUv:Ft&&h(v.emissiveMap.channel),metalnessMapUv:wn&&h(v.metalnessMap.channel),roughnessMapUv:Tn&&h(v.roughnessMap.channel),anisotropyMapUv:De&&h(v.anisotropyMap.channel),clearcoatMapUv:T&&h(v.clearcoatMap.channel),clearcoatNormalMapUv:y&&h(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:F&&h(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:te&&h(v.diffuseRoughnessMap.channel),iridescenceMapUv:Q&&h(v.iridescenceMap.channel),iridescenceThicknessMapUv:re&&h(v.iridescenceThicknessMap.channel),sheenColorMapUv:ue&&h(v.sheenColorMap.channel),sheenRoughnessMapUv:$&&h(v.sheenRoughnessMap.channel),specularMapUv:Y&&h(v.specularMap.channel),specularColorMapUv:oe&&h(v.specularColorMap.channel),specularIntensityMapUv:R&&h(v.specularIntensityMap.channel),transmissionMapUv:J&&h(v.transmissionMap.channel),thicknessMapUv:W&&h(v.thicknessMap.channel),alphaMapUv:se&&h(v.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(gt||An),vertexNormals:!!I.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!I.attributes.uv&&(Re||se),fog:!!H,useFog:v.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||I.attributes.normal===void 0&&gt===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:m,reversedDepthBuffer:ge,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:ee,morphTextureStride:Me,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:k.filter(fe=>fe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&B.length>0,shadowMapType:n.shadowMap.type,toneMapping:ie,decodeVideoTexture:Re&&v.map.isVideoTexture===!0&&Xe.getTransfer(v.map.colorSpace)===tt,decodeVideoTextureEmissive:Ft&&v.emissiveMap.isVideoTexture===!0&&Xe.getTransfer(v.emissiveMap.colorSpace)===tt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Dn,flipSided:v.side===on,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:ze&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ze&&v.extensions.multiDraw===!0||Mt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return Be.vertexUv1s=l.has(1),Be.vertexUv2s=l.has(2),Be.vertexUv3s=l.has(3),l.clear(),Be}function x(v){let w=[];if(v.shaderID?w.push(v.shaderID):(w.push(v.customVertexShaderID),w.push(v.customFragmentShaderID)),v.defines!==void 0)for(let B in v.defines)w.push(B),w.push(v.defines[B]);return v.isRawShaderMaterial===!1&&(p(w,v),f(w,v),w.push(n.outputColorSpace)),w.push(v.customProgramCacheKey),w.join()}function p(v,w){v.push(w.precision),v.push(w.outputColorSpace),v.push(w.envMapMode),v.push(w.envMapPMREM),v.push(w.envMapMaxLod),v.push(w.envMapSize),v.push(w.mapUv),v.push(w.alphaMapUv),v.push(w.lightMapUv),v.push(w.aoMapUv),v.push(w.bumpMapUv),v.push(w.normalMapUv),v.push(w.displacementMapUv),v.push(w.emissiveMapUv),v.push(w.metalnessMapUv),v.push(w.roughnessMapUv),v.push(w.anisotropyMapUv),v.push(w.clearcoatMapUv),v.push(w.clearcoatNormalMapUv),v.push(w.clearcoatRoughnessMapUv),v.push(w.diffuseRoughnessMapUv),v.push(w.iridescenceMapUv),v.push(w.iridescenceThicknessMapUv),v.push(w.sheenColorMapUv),v.push(w.sheenRoughnessMapUv),v.push(w.specularMapUv),v.push(w.specularColorMapUv),v.push(w.specularIntensityMapUv),v.push(w.transmissionMapUv),v.push(w.thicknessMapUv),v.push(w.combine),v.push(w.fogExp2),v.push(w.sizeAttenuation),v.push(w.morphTargetsCount),v.push(w.numSunLights),v.push(w.numDirLights),v.push(w.numPointLights),v.push(w.numSpotLights),v.push(w.numSpotLightMaps),v.push(w.numHemiLights),v.push(w.numRectAreaLights),v.push(w.numSunLightShadows),v.push(w.numDirLightShadows),v.push(w.numPointLightShadows),v.push(w.numSpotLightShadows),v.push(w.numSpotLightShadowsWithMaps),v.push(w.numLightProbes),v.push(w.numLightProbeGrids),v.push(w.shadowMapType),v.push(w.toneMapping),v.push(w.numClippingPlanes),v.push(w.numClipIntersection),v.push(w.depthPacking)}function f(v,w){a.disableAll(),w.instancing&&a.enable(0),w.instancingColor&&a.enable(1),w.instancingMorph&&a.enable(2),w.matcap&&a.enable(3),w.envMap&&a.enable(4),w.normalMapObjectSpace&&a.enable(5),w.normalMapTangentSpace&&a.enable(6),w.clearcoat&&a.enable(7),w.iridescence&&a.enable(8),w.alphaTest&&a.enable(9),w.vertexColors&&a.enable(10),w.vertexAlphas&&a.enable(11),w.vertexUv1s&&a.enable(12),w.vertexUv2s&&a.enable(13),w.vertexUv3s&&a.enable(14),w.vertexTangents&&a.enable(15),w.anisotropy&&a.enable(16),w.alphaHash&&a.enable(17),w.batching&&a.enable(18),w.dispersion&&a.enable(19),w.retroreflection&&a.enable(24),w.diffuseRoughness&&a.enable(25),w.batchingColor&&a.enable(20),w.gradientMap&&a.enable(21),w.packedNormalMap&&a.enable(22),w.vertexNormals&&a.enable(23),v.push(a.mask),a.disableAll(),w.fog&&a.enable(0),w.useFog&&a.enable(1),w.flatShading&&a.enable(2),w.logarithmicDepthBuffer&&a.enable(3),w.reversedDepthBuffer&&a.enable(4),w.skinning&&a.enable(5),w.morphTargets&&a.enable(6),w.morphNormals&&a.enable(7),w.morphColors&&a.enable(8),w.premultipliedAlpha&&a.enable(9),w.shadowMapEnabled&&a.enable(10),w.doubleSided&&a.enable(11),w.flipSided&&a.enable(12),w.useDepthPacking&&a.enable(13),w.dithering&&a.enable(14),w.transmission&&a.enable(15),w.sheen&&a.enable(16),w.opaque&&a.enable(17),w.pointsUvs&&a.enable(18),w.decodeVideoTexture&&a.enable(19),w.decodeVideoTextureEmissive&&a.enable(20),w.alphaToCoverage&&a.enable(21),w.numLightProbeGrids>0&&a.enable(22),w.hasPositionAttribute&&a.enable(23),v.push(a.mask)}function M(v){let w=d[v.type],B;if(w){let L=oi[w];B=pp.clone(L.uniforms)}else B=v.uniforms;return B}function A(v,w){let B=u.get(w);return B!==void 0?++B.usedTimes:(B=new hb(n,w,v,s),c.push(B),u.set(w,B)),B}function S(v){if(--v.usedTimes===0){let w=c.indexOf(v);c[w]=c[c.length-1],c.pop(),u.delete(v.cacheKey),v.destroy()}}function C(v){o.remove(v)}function E(){o.dispose()}return{getParameters:_,getProgramCacheKey:x,getUniforms:M,acquireProgram:A,releaseProgram:S,releaseShaderCache:C,programs:c,dispose:E}}function mb(){let n=new WeakMap;function e(a){return n.has(a)}function t(a){let o=n.get(a);return o===void 0&&(o={},n.set(a,o)),o}function i(a){n.delete(a)}function s(a,o,l){n.get(a)[o]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function gb(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Dp(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Up(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function a(d){let h=0;return d.isInstancedMesh&&(h+=2),d.isSkinnedMesh&&(h+=1),h}function o(d,h,_,x,p,f){let M=n[e];return M===void 0?(M={id:d.id,object:d,geometry:h,material:_,materialVariant:a(d),groupOrder:x,renderOrder:d.renderOrder,z:p,group:f},n[e]=M):(M.id=d.id,M.object=d,M.geometry=h,M.material=_,M.materialVariant=a(d),M.groupOrder=x,M.renderOrder=d.renderOrder,M.z=p,M.group=f),e++,M}function l(d,h,_,x,p,f,M){M.reversedDepth===!0&&(p=-p);let A=o(d,h,_,x,p,f);_.transmission>0?i.push(A):_.transparent===!0?s.push(A):t.push(A)}function c(d,h,_,x,p,f){let M=o(d,h,_,x,p,f);_.transmission>0?i.unshift(M):_.transparent===!0?s.unshift(M):t.unshift(M)}function u(d,h){t.length>1&&t.sort(d||gb),i.length>1&&i.sort(h||Dp),s.length>1&&s.sort(h||Dp)}function m(){for(let d=e,h=n.length;d<h;d++){let _=n[d];if(_.id===null)break;_.id=null,_.object=null,_.geometry=null,_.material=null,_.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:m,sort:u}}function _b(){let n=new WeakMap;function e(i,s){let r=n.get(i),a;return r===void 0?(a=new Up,n.set(i,[a])):s>=r.length?(a=new Up,r.push(a)):a=r[s],a}function t(){n=new WeakMap}return{get:e,dispose:t}}function vb(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new V,color:new Ke};break;case"SpotLight":t={position:new V,direction:new V,color:new Ke,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new V,color:new Ke,distance:0,decay:0};break;case"HemisphereLight":t={direction:new V,skyColor:new Ke,groundColor:new Ke};break;case"RectAreaLight":t={color:new Ke,position:new V,halfWidth:new V,halfHeight:new V};break}return n[e.id]=t,t}}}function xb(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ye};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ye};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ye,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var yb=0;function bb(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function Mb(n){let e=new vb,t=xb(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new V);let s=new V,r=new lt,a=new lt;function o(c){let u=0,m=0,d=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let h=0,_=0,x=0,p=0,f=0,M=0,A=0,S=0,C=0,E=0,v=0,w=0,B=0,L=0;c.sort(bb);for(let k=0,H=c.length;k<H;k++){let I=c[k],q=I.color,K=I.intensity,G=I.distance,ne=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===ri?ne=I.shadow.map.texture:ne=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)u+=q.r*K,m+=q.g*K,d+=q.b*K;else if(I.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(I.sh.coefficients[X],K);L++}else if(I.isSunLight){let X=e.get(I);if(X.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let j=I.shadow,ee=t.get(I);ee.shadowIntensity=j.intensity,ee.shadowBias=j.bias,ee.shadowNormalBias=j.normalBias,ee.shadowRadius=j.radius,ee.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[_]=ee,i.sunShadowMap[_]=ne;let Me=j.getViewportCount();for(let Ue=0;Ue<Me;Ue++)i.sunShadowMatrix[x+Ue]=j.getMatrix(Ue),i.sunShadowCascade[x+Ue]=j._cascadeData[Ue];x+=Me,_++}i.sun[h]=X,h++}else if(I.isDirectionalLight){let X=e.get(I);if(X.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let j=I.shadow,ee=t.get(I);ee.shadowIntensity=j.intensity,ee.shadowBias=j.bias,ee.shadowNormalBias=j.normalBias,ee.shadowRadius=j.radius,ee.shadowMapSize=j.mapSize,i.directionalShadow[p]=ee,i.directionalShadowMap[p]=ne,i.directionalShadowMatrix[p]=I.shadow.matrix,C++}i.directional[p]=X,p++}else if(I.isSpotLight){let X=e.get(I);X.position.setFromMatrixPosition(I.matrixWorld),X.color.copy(q).multiplyScalar(K),X.distance=G,X.coneCos=Math.cos(I.angle),X.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),X.decay=I.decay,i.spot[M]=X;let j=I.shadow;if(I.map&&(i.spotLightMap[w]=I.map,w++,j.updateMatrices(I),I.castShadow&&B++),i.spotLightMatrix[M]=j.matrix,I.castShadow){let ee=t.get(I);ee.shadowIntensity=j.intensity,ee.shadowBias=j.bias,ee.shadowNormalBias=j.normalBias,ee.shadowRadius=j.radius,ee.shadowMapSize=j.mapSize,i.spotShadow[M]=ee,i.spotShadowMap[M]=ne,v++}M++}else if(I.isRectAreaLight){let X=e.get(I);X.color.copy(q).multiplyScalar(K),X.halfWidth.set(I.width*.5,0,0),X.halfHeight.set(0,I.height*.5,0),i.rectArea[A]=X,A++}else if(I.isPointLight){let X=e.get(I);if(X.color.copy(I.color).multiplyScalar(I.intensity),X.distance=I.distance,X.decay=I.decay,I.castShadow){let j=I.shadow,ee=t.get(I);ee.shadowIntensity=j.intensity,ee.shadowBias=j.bias,ee.shadowNormalBias=j.normalBias,ee.shadowRadius=j.radius,ee.shadowMapSize=j.mapSize,ee.shadowCameraNear=j.camera.near,ee.shadowCameraFar=j.camera.far,i.pointShadow[f]=ee,i.pointShadowMap[f]=ne,i.pointShadowMatrix[f]=I.shadow.matrix,E++}i.point[f]=X,f++}else if(I.isHemisphereLight){let X=e.get(I);X.skyColor.copy(I.color).multiplyScalar(K),X.groundColor.copy(I.groundColor).multiplyScalar(K),i.hemi[S]=X,S++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=pe.LTC_FLOAT_1,i.rectAreaLTC2=pe.LTC_FLOAT_2):(i.rectAreaLTC1=pe.LTC_HALF_1,i.rectAreaLTC2=pe.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=m,i.ambient[2]=d;let D=i.hash;(D.sunLength!==h||D.directionalLength!==p||D.pointLength!==f||D.spotLength!==M||D.rectAreaLength!==A||D.hemiLength!==S||D.numSunShadows!==_||D.numDirectionalShadows!==C||D.numPointShadows!==E||D.numSpotShadows!==v||D.numSpotMaps!==w||D.numLightProbes!==L)&&(i.sun.length=h,i.directional.length=p,i.spot.length=M,i.rectArea.length=A,i.point.length=f,i.hemi.length=S,i.sunShadow.length=_,i.sunShadowMap.length=_,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+w-B,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=B,i.numLightProbes=L,D.sunLength=h,D.directionalLength=p,D.pointLength=f,D.spotLength=M,D.rectAreaLength=A,D.hemiLength=S,D.numSunShadows=_,D.numDirectionalShadows=C,D.numPointShadows=E,D.numSpotShadows=v,D.numSpotMaps=w,D.numLightProbes=L,i.version=yb++)}function l(c,u){let m=0,d=0,h=0,_=0,x=0,p=0,f=u.matrixWorldInverse;for(let M=0,A=c.length;M<A;M++){let S=c[M];if(S.isSunLight){let C=i.sun[m];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(f),m++}else if(S.isDirectionalLight){let C=i.directional[d];C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(f),d++}else if(S.isSpotLight){let C=i.spot[_];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(f),C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(f),_++}else if(S.isRectAreaLight){let C=i.rectArea[x];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(f),a.identity(),r.copy(S.matrixWorld),r.premultiply(f),a.extractRotation(r),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(a),C.halfHeight.applyMatrix4(a),x++}else if(S.isPointLight){let C=i.point[h];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(f),h++}else if(S.isHemisphereLight){let C=i.hemi[p];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(f),p++}}}return{setup:o,setupView:l,state:i}}function Fp(n){let e=new Mb(n),t=[],i=[],s=[];function r(m){u.camera=m,t.length=0,i.length=0,s.length=0}function a(m){m.isLightProbeGrid?s.push(m):t.push(m)}function o(m){i.push(m)}function l(){e.setup(t),s.sort((m,d)=>m.priority-d.priority||m.id-d.id)}function c(m){e.setupView(t,m)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function Sb(n){let e=new WeakMap;function t(s,r=0){let a=e.get(s),o;return a===void 0?(o=new Fp(n),e.set(s,[o])):r>=a.length?(o=new Fp(n),a.push(o)):o=a[r],o}function i(){e=new WeakMap}return{get:t,dispose:i}}var wb=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Tb=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Ab=[new V(1,0,0),new V(-1,0,0),new V(0,1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1)],Eb=[new V(0,-1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1),new V(0,-1,0),new V(0,-1,0)],Op=new lt,va=new V,oh=new V;function Cb(n,e,t){let i=new Ms,s=new Ye,r=new Ye,a=new xt,o=new sl,l=new rl,c={},u=t.maxTextureSize,m={[Qi]:on,[on]:Qi,[Dn]:Dn},d=new ni({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ye},radius:{value:4}},vertexShader:wb,fragmentShader:Tb}),h=d.clone();h.defines.HORIZONTAL_PASS=1;let _=new ti;_.setAttribute("position",new dn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new qt(_,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ca;let f=this.type;this.render=function(E,v,w){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;this.type===If&&(Ie("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ca);let B=n.getRenderTarget(),L=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),k=n.state;k.setBlending(Ss),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let H=f!==this.type;H&&v.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(q=>q.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,q=E.length;I<q;I++){let K=E[I],G=K.shadow;if(G===void 0){Ie("WebGLShadowMap:",K,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let ne=G.getFrameExtents();s.multiply(ne),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ne.x),s.x=r.x*ne.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ne.y),s.y=r.y*ne.y,G.mapSize.y=r.y));let X=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=X,G.map===null||H===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===hr){if(K.isPointLight){Ie("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new Gt(s.x,s.y,{format:ri,type:qn,minFilter:mt,magFilter:mt,generateMipmaps:!1}),G.map.texture.name=K.name+".shadowMap",G.map.depthTexture=new Ti(s.x,s.y,Sn),G.map.depthTexture.name=K.name+".shadowMapDepth",G.map.depthTexture.format=Si,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Vt,G.map.depthTexture.magFilter=Vt}else K.isPointLight?(G.map=new ya(s.x),G.map.depthTexture=new sa(s.x,Xn)):(G.map=new Gt(s.x,s.y),G.map.depthTexture=new Ti(s.x,s.y,Xn)),G.map.depthTexture.name=K.name+".shadowMap",G.map.depthTexture.format=Si,this.type===ca?(G.map.depthTexture.compareFunction=X?Qu:Ku,G.map.depthTexture.minFilter=mt,G.map.depthTexture.magFilter=mt):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Vt,G.map.depthTexture.magFilter=Vt);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let j=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();K.isPointLight!==!0&&G.updateMatrices(K,w);let ee=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:w.layers;for(let Me=0;Me<j;Me++){let Ue=G.getCamera(Me);if(K.isPointLight){let Z=G.camera,me=G.matrix,xe=K.distance||Z.far;xe!==Z.far&&(Z.far=xe,Z.updateProjectionMatrix()),va.setFromMatrixPosition(K.matrixWorld),Z.position.copy(va),oh.copy(Z.position),oh.add(Ab[Me]),Z.up.copy(Eb[Me]),Z.lookAt(oh),Z.updateMatrixWorld(),me.makeTranslation(-va.x,-va.y,-va.z),Op.multiplyMatrices(Z.projectionMatrix,Z.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Op,Z.coordinateSystem,Z.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,Me),n.clear();else{Me===0&&(n.setRenderTarget(G.map),n.clear());let Z=G.getViewport(Me);a.set(r.x*Z.x,r.y*Z.y,r.x*Z.z,r.y*Z.w),k.viewport(a)}i=G.getFrustum(Me),S(v,w,Ue,K,ee,this.type)}G.isPointLightShadow!==!0&&this.type===hr&&M(G,w),G.needsUpdate=!1}f=this.type,p.needsUpdate=!1,n.setRenderTarget(B,L,D)};function M(E,v){let w=e.update(x);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,h.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,h.needsUpdate=!0),E.mapPass===null?E.mapPass=new Gt(s.x,s.y,{format:ri,type:qn}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(v,null,w,d,x,null),h.uniforms.shadow_pass.value=E.mapPass.texture,h.uniforms.resolution.value.set(E.map.width,E.map.height),h.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(v,null,w,h,x,null)}function A(E,v,w,B){let L=null,D=w.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)L=D;else if(L=w.isPointLight===!0?l:o,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let k=L.uuid,H=v.uuid,I=c[k];I===void 0&&(I={},c[k]=I);let q=I[H];q===void 0&&(q=L.clone(),I[H]=q,v.addEventListener("dispose",C)),L=q}if(L.visible=v.visible,L.wireframe=v.wireframe,B===hr?L.side=v.shadowSide!==null?v.shadowSide:v.side:L.side=v.shadowSide!==null?v.shadowSide:m[v.side],L.alphaMap=v.alphaMap,L.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,L.map=v.map,L.clipShadows=v.clipShadows,L.clippingPlanes=v.clippingPlanes,L.clipIntersection=v.clipIntersection,L.displacementMap=v.displacementMap,L.displacementScale=v.displacementScale,L.displacementBias=v.displacementBias,L.wireframeLinewidth=v.wireframeLinewidth,L.linewidth=v.linewidth,w.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let k=n.properties.get(L);k.light=w}return L}function S(E,v,w,B,L,D){if(E.visible===!1)return;if(E.layers.test(L)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===hr)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,E.matrixWorld);let I=e.update(E),q=E.material;if(Array.isArray(q)){let K=I.groups;for(let G=0,ne=K.length;G<ne;G++){let X=K[G],j=q[X.materialIndex];if(j&&j.visible){let ee=A(E,j,B,D);E.onBeforeShadow(n,E,v,w,I,ee,X),n.renderBufferDirect(w,null,I,ee,E,X),E.onAfterShadow(n,E,v,w,I,ee,X)}}}else if(q.visible){let K=A(E,q,B,D);E.onBeforeShadow(n,E,v,w,I,K,null),n.renderBufferDirect(w,null,I,K,E,null),E.onAfterShadow(n,E,v,w,I,K,null)}}let H=E.children;for(let I=0,q=H.length;I<q;I++)S(H[I],v,w,B,L,D)}function C(E){E.target.removeEventListener("dispose",C);for(let w in c){let B=c[w],L=E.target.uuid;L in B&&(B[L].dispose(),delete B[L])}}}function Rb(n,e){function t(){let R=!1,J=new xt,W=null,le=new xt(0,0,0,0);return{setMask:function(se){W!==se&&!R&&(n.colorMask(se,se,se,se),W=se)},setLocked:function(se){R=se},setClear:function(se,ae,we,ze,ie){ie===!0&&(se*=ze,ae*=ze,we*=ze),J.set(se,ae,we,ze),le.equals(J)===!1&&(n.clearColor(se,ae,we,ze),le.copy(J))},reset:function(){R=!1,W=null,le.set(-1,0,0,0)}}}function i(){let R=!1,J=!1,W=null,le=null,se=null;return{setReversed:function(ae){if(J!==ae){let we=e.get("EXT_clip_control");ae?we.clipControlEXT(we.LOWER_LEFT_EXT,we.ZERO_TO_ONE_EXT):we.clipControlEXT(we.LOWER_LEFT_EXT,we.NEGATIVE_ONE_TO_ONE_EXT),J=ae;let ze=se;se=null,this.setClear(ze)}},getReversed:function(){return J},setTest:function(ae){ae?ge(n.DEPTH_TEST):Oe(n.DEPTH_TEST)},setMask:function(ae){W!==ae&&!R&&(n.depthMask(ae),W=ae)},setFunc:function(ae){if(J&&(ae=hp[ae]),le!==ae){switch(ae){case Vo:n.depthFunc(n.NEVER);break;case Go:n.depthFunc(n.ALWAYS);break;case Ho:n.depthFunc(n.LESS);break;case sr:n.depthFunc(n.LEQUAL);break;case Wo:n.depthFunc(n.EQUAL);break;case Xo:n.depthFunc(n.GEQUAL);break;case qo:n.depthFunc(n.GREATER);break;case $o:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}le=ae}},setLocked:function(ae){R=ae},setClear:function(ae){se!==ae&&(se=ae,J&&(ae=1-ae),n.clearDepth(ae))},reset:function(){R=!1,W=null,le=null,se=null,J=!1}}}function s(){let R=!1,J=null,W=null,le=null,se=null,ae=null,we=null,ze=null,ie=null;return{setTest:function(Ae){R||(Ae?ge(n.STENCIL_TEST):Oe(n.STENCIL_TEST))},setMask:function(Ae){J!==Ae&&!R&&(n.stencilMask(Ae),J=Ae)},setFunc:function(Ae,Be,fe){(W!==Ae||le!==Be||se!==fe)&&(n.stencilFunc(Ae,Be,fe),W=Ae,le=Be,se=fe)},setOp:function(Ae,Be,fe){(ae!==Ae||we!==Be||ze!==fe)&&(n.stencilOp(Ae,Be,fe),ae=Ae,we=Be,ze=fe)},setLocked:function(Ae){R=Ae},setClear:function(Ae){ie!==Ae&&(n.clearStencil(Ae),ie=Ae)},reset:function(){R=!1,J=null,W=null,le=null,se=null,ae=null,we=null,ze=null,ie=null}}}let r=new t,a=new i,o=new s,l={},c=new WeakMap,u={},m={},d={},h=new WeakMap,_=[],x=null,p=!1,f=null,M=null,A=null,S=null,C=null,E=null,v=null,w=new Ke(0,0,0),B=0,L=!1,D=null,k=null,H=null,I=null,q=null,K=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,ne=0,X=n.getParameter(n.VERSION);X.indexOf("WebGL")!==-1?(ne=parseFloat(/^WebGL (\d)/.exec(X)[1]),G=ne>=1):X.indexOf("OpenGL ES")!==-1&&(ne=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),G=ne>=2);let j=null,ee={},Me=n.getParameter(n.SCISSOR_BOX),Ue=n.getParameter(n.VIEWPORT),Z=new xt().fromArray(Me),me=new xt().fromArray(Ue);function xe(R,J,W,le){let se=new Uint8Array(4),ae=n.createTexture();n.bindTexture(R,ae),n.texParameteri(R,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(R,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let we=0;we<W;we++)R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY?n.texImage3D(J,0,n.RGBA,1,1,le,0,n.RGBA,n.UNSIGNED_BYTE,se):n.texImage2D(J+we,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,se);return ae}let Ee={};Ee[n.TEXTURE_2D]=xe(n.TEXTURE_2D,n.TEXTURE_2D,1),Ee[n.TEXTURE_CUBE_MAP]=xe(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ee[n.TEXTURE_2D_ARRAY]=xe(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ee[n.TEXTURE_3D]=xe(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),ge(n.DEPTH_TEST),a.setFunc(sr),ln(!1),gt(Cu),ge(n.CULL_FACE),Ht(Ss);function ge(R){u[R]!==!0&&(n.enable(R),u[R]=!0)}function Oe(R){u[R]!==!1&&(n.disable(R),u[R]=!1)}function Mt(R,J){return d[R]!==J?(n.bindFramebuffer(R,J),d[R]=J,R===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=J),R===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=J),!0):!1}function Re(R,J){let W=_,le=!1;if(R){W=h.get(J),W===void 0&&(W=[],h.set(J,W));let se=R.textures;if(W.length!==se.length||W[0]!==n.COLOR_ATTACHMENT0){for(let ae=0,we=se.length;ae<we;ae++)W[ae]=n.COLOR_ATTACHMENT0+ae;W.length=se.length,le=!0}}else W[0]!==n.BACK&&(W[0]=n.BACK,le=!0);le&&n.drawBuffers(W)}function nt(R){return x!==R?(n.useProgram(R),x=R,!0):!1}let at={[ws]:n.FUNC_ADD,[Nf]:n.FUNC_SUBTRACT,[Df]:n.FUNC_REVERSE_SUBTRACT};at[Uf]=n.MIN,at[Ff]=n.MAX;let Ge={[Of]:n.ZERO,[Bf]:n.ONE,[kf]:n.SRC_COLOR,[Lu]:n.SRC_ALPHA,[Xf]:n.SRC_ALPHA_SATURATE,[Hf]:n.DST_COLOR,[Vf]:n.DST_ALPHA,[zf]:n.ONE_MINUS_SRC_COLOR,[Nu]:n.ONE_MINUS_SRC_ALPHA,[Wf]:n.ONE_MINUS_DST_COLOR,[Gf]:n.ONE_MINUS_DST_ALPHA,[qf]:n.CONSTANT_COLOR,[$f]:n.ONE_MINUS_CONSTANT_COLOR,[Yf]:n.CONSTANT_ALPHA,[Zf]:n.ONE_MINUS_CONSTANT_ALPHA};function Ht(R,J,W,le,se,ae,we,ze,ie,Ae){if(R===Ss){p===!0&&(Oe(n.BLEND),p=!1);return}if(p===!1&&(ge(n.BLEND),p=!0),R!==Lf){if(R!==f||Ae!==L){if((M!==ws||C!==ws)&&(n.blendEquation(n.FUNC_ADD),M=ws,C=ws),Ae)switch(R){case dr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ru:n.blendFunc(n.ONE,n.ONE);break;case Pu:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Iu:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Le("WebGLState: Invalid blending: ",R);break}else switch(R){case dr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ru:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Pu:Le("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Iu:Le("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Le("WebGLState: Invalid blending: ",R);break}A=null,S=null,E=null,v=null,w.set(0,0,0),B=0,f=R,L=Ae}return}se=se||J,ae=ae||W,we=we||le,(J!==M||se!==C)&&(n.blendEquationSeparate(at[J],at[se]),M=J,C=se),(W!==A||le!==S||ae!==E||we!==v)&&(n.blendFuncSeparate(Ge[W],Ge[le],Ge[ae],Ge[we]),A=W,S=le,E=ae,v=we),(ze.equals(w)===!1||ie!==B)&&(n.blendColor(ze.r,ze.g,ze.b,ie),w.copy(ze),B=ie),f=R,L=!1}function Ct(R,J){R.side===Dn?Oe(n.CULL_FACE):ge(n.CULL_FACE);let W=R.side===on;J&&(W=!W),ln(W),R.blending===dr&&R.transparent===!1?Ht(Ss):Ht(R.blending,R.blendEquation,R.blendSrc,R.blendDst,R.blendEquationAlpha,R.blendSrcAlpha,R.blendDstAlpha,R.blendColor,R.blendAlpha,R.premultipliedAlpha),a.setFunc(R.depthFunc),a.setTest(R.depthTest),a.setMask(R.depthWrite),r.setMask(R.colorWrite);let le=R.stencilWrite;o.setTest(le),le&&(o.setMask(R.stencilWriteMask),o.setFunc(R.stencilFunc,R.stencilRef,R.stencilFuncMask),o.setOp(R.stencilFail,R.stencilZFail,R.stencilZPass)),Ft(R.polygonOffset,R.polygonOffsetFactor,R.polygonOffsetUnits),R.alphaToCoverage===!0?ge(n.SAMPLE_ALPHA_TO_COVERAGE):Oe(n.SAMPLE_ALPHA_TO_COVERAGE)}function ln(R){D!==R&&(R?n.frontFace(n.CW):n.frontFace(n.CCW),D=R)}function gt(R){R!==Rf?(ge(n.CULL_FACE),R!==k&&(R===Cu?n.cullFace(n.BACK):R===Pf?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Oe(n.CULL_FACE),k=R}function $n(R){R!==H&&(G&&n.lineWidth(R),H=R)}function Ft(R,J,W){R?(ge(n.POLYGON_OFFSET_FILL),(I!==J||q!==W)&&(I=J,q=W,a.getReversed()&&(J=-J,W=-W),n.polygonOffset(J,W))):Oe(n.POLYGON_OFFSET_FILL)}function wn(R){R?ge(n.SCISSOR_TEST):Oe(n.SCISSOR_TEST)}function Tn(R){R===void 0&&(R=n.TEXTURE0+K-1),j!==R&&(n.activeTexture(R),j=R)}function An(R,J,W){W===void 0&&(j===null?W=n.TEXTURE0+K-1:W=j);let le=ee[W];le===void 0&&(le={type:void 0,texture:void 0},ee[W]=le),(le.type!==R||le.texture!==J)&&(j!==W&&(n.activeTexture(W),j=W),n.bindTexture(R,J||Ee[R]),le.type=R,le.texture=J)}function N(){let R=ee[j];R!==void 0&&R.type!==void 0&&(n.bindTexture(R.type,null),R.type=void 0,R.texture=void 0)}function En(){try{n.compressedTexImage2D(...arguments)}catch(R){Le("WebGLState:",R)}}function ht(){try{n.compressedTexImage3D(...arguments)}catch(R){Le("WebGLState:",R)}}function dt(){try{n.texSubImage2D(...arguments)}catch(R){Le("WebGLState:",R)}}function de(){try{n.texSubImage3D(...arguments)}catch(R){Le("WebGLState:",R)}}function Rt(){try{n.compressedTexSubImage2D(...arguments)}catch(R){Le("WebGLState:",R)}}function Ce(){try{n.compressedTexSubImage3D(...arguments)}catch(R){Le("WebGLState:",R)}}function De(){try{n.texStorage2D(...arguments)}catch(R){Le("WebGLState:",R)}}function T(){try{n.texStorage3D(...arguments)}catch(R){Le("WebGLState:",R)}}function y(){try{n.texImage2D(...arguments)}catch(R){Le("WebGLState:",R)}}function F(){try{n.texImage3D(...arguments)}catch(R){Le("WebGLState:",R)}}function te(R){return m[R]!==void 0?m[R]:n.getParameter(R)}function Q(R,J){m[R]!==J&&(n.pixelStorei(R,J),m[R]=J)}function re(R){Z.equals(R)===!1&&(n.scissor(R.x,R.y,R.z,R.w),Z.copy(R))}function ue(R){me.equals(R)===!1&&(n.viewport(R.x,R.y,R.z,R.w),me.copy(R))}function $(R,J){let W=c.get(J);W===void 0&&(W=new WeakMap,c.set(J,W));let le=W.get(R);le===void 0&&(le=n.getUniformBlockIndex(J,R.name),n.uniformBlockBinding(J,le,le),W.set(R,le))}function Y(R,J,W){let se=c.get(J).get(R);l[se]!==W&&(n.bindBufferBase(n.UNIFORM_BUFFER,se,W),l[se]=W)}function oe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),a.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},m={},j=null,ee={},d={},l={},h=new WeakMap,_=[],x=null,p=!1,f=null,M=null,A=null,S=null,C=null,E=null,v=null,w=new Ke(0,0,0),B=0,L=!1,D=null,k=null,H=null,I=null,q=null,Z.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:ge,disable:Oe,bindFramebuffer:Mt,drawBuffers:Re,useProgram:nt,setBlending:Ht,setMaterial:Ct,setFlipSided:ln,setCullFace:gt,setLineWidth:$n,setPolygonOffset:Ft,setScissorTest:wn,activeTexture:Tn,bindTexture:An,unbindTexture:N,compressedTexImage2D:En,compressedTexImage3D:ht,texImage2D:y,texImage3D:F,pixelStorei:Q,getParameter:te,updateUBOMapping:$,uniformBlockBinding:Y,texStorage2D:De,texStorage3D:T,texSubImage2D:dt,texSubImage3D:de,compressedTexSubImage2D:Rt,compressedTexSubImage3D:Ce,scissor:re,viewport:ue,reset:oe}}function Pb(n,e,t,i,s,r,a){let o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ye,u=new WeakMap,m=new Set,d,h=new WeakMap,_=new Set,x=new FinalizationRegistry(T=>_.delete(T)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function f(T,y){return p?new OffscreenCanvas(T,y):Qr("canvas")}function M(T,y,F){let te=1,Q=De(T);if((Q.width>F||Q.height>F)&&(te=F/Math.max(Q.width,Q.height)),te<1)if(typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&T instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&T instanceof ImageBitmap||typeof VideoFrame<"u"&&T instanceof VideoFrame){let re=Math.floor(te*Q.width),ue=Math.floor(te*Q.height);d===void 0&&(d=f(re,ue));let $=y?f(re,ue):d;return $.width=re,$.height=ue,$.getContext("2d").drawImage(T,0,0,re,ue),Ie("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+re+"x"+ue+")."),$}else return"data"in T&&Ie("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),T;return T}function A(T){return T.generateMipmaps}function S(T){n.generateMipmap(T)}function C(T){return T.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:T.isWebGL3DRenderTarget?n.TEXTURE_3D:T.isWebGLArrayRenderTarget||T.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(T,y,F,te,Q,re=!1){if(T!==null){if(n[T]!==void 0)return n[T];Ie("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+T+"'")}let ue;te&&(ue=e.get("EXT_texture_norm16"),ue||Ie("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let $=y;if(y===n.RED&&(F===n.FLOAT&&($=n.R32F),F===n.HALF_FLOAT&&($=n.R16F),F===n.UNSIGNED_BYTE&&($=n.R8),F===n.UNSIGNED_SHORT&&ue&&($=ue.R16_EXT),F===n.SHORT&&ue&&($=ue.R16_SNORM_EXT)),y===n.RED_INTEGER&&(F===n.UNSIGNED_BYTE&&($=n.R8UI),F===n.UNSIGNED_SHORT&&($=n.R16UI),F===n.UNSIGNED_INT&&($=n.R32UI),F===n.BYTE&&($=n.R8I),F===n.SHORT&&($=n.R16I),F===n.INT&&($=n.R32I)),y===n.RG&&(F===n.FLOAT&&($=n.RG32F),F===n.HALF_FLOAT&&($=n.RG16F),F===n.UNSIGNED_BYTE&&($=n.RG8),F===n.UNSIGNED_SHORT&&ue&&($=ue.RG16_EXT),F===n.SHORT&&ue&&($=ue.RG16_SNORM_EXT)),y===n.RG_INTEGER&&(F===n.UNSIGNED_BYTE&&($=n.RG8UI),F===n.UNSIGNED_SHORT&&($=n.RG16UI),F===n.UNSIGNED_INT&&($=n.RG32UI),F===n.BYTE&&($=n.RG8I),F===n.SHORT&&($=n.RG16I),F===n.INT&&($=n.RG32I)),y===n.RGB_INTEGER&&(F===n.UNSIGNED_BYTE&&($=n.RGB8UI),F===n.UNSIGNED_SHORT&&($=n.RGB16UI),F===n.UNSIGNED_INT&&($=n.RGB32UI),F===n.BYTE&&($=n.RGB8I),F===n.SHORT&&($=n.RGB16I),F===n.INT&&($=n.RGB32I)),y===n.RGBA_INTEGER&&(F===n.UNSIGNED_BYTE&&($=n.RGBA8UI),F===n.UNSIGNED_SHORT&&($=n.RGBA16UI),F===n.UNSIGNED_INT&&($=n.RGBA32UI),F===n.BYTE&&($=n.RGBA8I),F===n.SHORT&&($=n.RGBA16I),F===n.INT&&($=n.RGBA32I)),y===n.RGB&&(F===n.UNSIGNED_SHORT&&ue&&($=ue.RGB16_EXT),F===n.SHORT&&ue&&($=ue.RGB16_SNORM_EXT),F===n.UNSIGNED_INT_5_9_9_9_REV&&($=n.RGB9_E5),F===n.UNSIGNED_INT_10F_11F_11F_REV&&($=n.R11F_G11F_B10F)),y===n.RGBA){let Y=re?Jr:Xe.getTransfer(Q);F===n.FLOAT&&($=n.RGBA32F),F===n.HALF_FLOAT&&($=n.RGBA16F),F===n.UNSIGNED_BYTE&&($=Y===tt?n.SRGB8_ALPHA8:n.RGBA8),F===n.UNSIGNED_SHORT&&ue&&($=ue.RGBA16_EXT),F===n.SHORT&&ue&&($=ue.RGBA16_SNORM_EXT),F===n.UNSIGNED_SHORT_4_4_4_4&&($=n.RGBA4),F===n.UNSIGNED_SHORT_5_5_5_1&&($=n.RGB5_A1)}return($===n.R16F||$===n.R32F||$===n.RG16F||$===n.RG32F||$===n.RGBA16F||$===n.RGBA32F)&&e.get("EXT_color_buffer_float"),$}function v(T,y){let F;return T?y===null||y===Xn||y===As?F=n.DEPTH24_STENCIL8:y===Sn?F=n.DEPTH32F_STENCIL8:y===pr&&(F=n.DEPTH24_STENCIL8,Ie("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===Xn||y===As?F=n.DEPTH_COMPONENT24:y===Sn?F=n.DEPTH_COMPONENT32F:y===pr&&(F=n.DEPTH_COMPONENT16),F}function w(T,y){return A(T)===!0||T.isFramebufferTexture&&T.minFilter!==Vt&&T.minFilter!==mt?Math.log2(Math.max(y.width,y.height))+1:T.mipmaps.length>0?T.mipmaps.length:T.isCompressedTexture&&Array.isArray(T.image)?y.mipmaps.length:1}function B(T){let y=new WeakRef(T);i.get(T).__ref=y,_.add(y),x.register(T,y,y)}function L(T){let y=i.get(T).__ref;y!==void 0&&(_.delete(y),x.unregister(y))}function D(T){H(T.target)}function k(T){I(T.target)}function H(T){T.removeEventListener("dispose",D),L(T),K(T),T.isVideoTexture&&u.delete(T),T.isHTMLTexture&&m.delete(T)}function I(T){T.removeEventListener("dispose",k),L(T),ne(T)}function q(){for(let T of _){let y=T.deref();y!==void 0&&(y.isRenderTarget===!0?I(y):H(y))}_.clear(),m.clear()}function K(T){let y=i.get(T);if(y.__webglInit===void 0)return;let F=T.source,te=h.get(F);if(te){let Q=te[y.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&G(T),Object.keys(te).length===0&&h.delete(F)}i.remove(T)}function G(T){let y=i.get(T);n.deleteTexture(y.__webglTexture);let F=T.source,te=h.get(F);delete te[y.__cacheKey],a.memory.textures--}function ne(T){let y=i.get(T);y.__depthDisposeCallback&&y.__depthDisposeCallback();let F=T.depthTexture;if(F&&F.renderTarget===T&&H(F),T.isWebGLCubeRenderTarget)for(let Q=0;Q<6;Q++){if(Array.isArray(y.__webglFramebuffer[Q]))for(let re=0;re<y.__webglFramebuffer[Q].length;re++)n.deleteFramebuffer(y.__webglFramebuffer[Q][re]);else n.deleteFramebuffer(y.__webglFramebuffer[Q]);y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer[Q])}else{if(Array.isArray(y.__webglFramebuffer))for(let Q=0;Q<y.__webglFramebuffer.length;Q++)n.deleteFramebuffer(y.__webglFramebuffer[Q]);else n.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&n.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let Q=0;Q<y.__webglColorRenderbuffer.length;Q++)y.__webglColorRenderbuffer[Q]&&n.deleteRenderbuffer(y.__webglColorRenderbuffer[Q]);y.__webglDepthRenderbuffer&&n.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let te=T.textures;for(let Q=0,re=te.length;Q<re;Q++){let ue=i.get(te[Q]);ue.__webglTexture&&(n.deleteTexture(ue.__webglTexture),a.memory.textures--),i.remove(te[Q])}i.remove(T)}let X=0;function j(){X=0}function ee(){return X}function Me(T){X=T}function Ue(){let T=X;return T>=s.maxTextures&&Ie("WebGLTextures: Trying to use "+(T+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,T}function Z(T){let y=[];return y.push(T.wrapS),y.push(T.wrapT),y.push(T.wrapR||0),y.push(T.magFilter),y.push(T.minFilter),y.push(T.anisotropy),y.push(T.internalFormat),y.push(T.format),y.push(T.type),y.push(T.generateMipmaps),y.push(T.mipmapsAutoUpdate),y.push(T.premultiplyAlpha),y.push(T.flipY),y.push(T.unpackAlignment),y.push(T.colorSpace),y.join()}function me(T,y){let F=i.get(T);if(T.isVideoTexture&&Rt(T),T.isRenderTargetTexture===!1&&T.isExternalTexture!==!0&&T.version>0&&F.__version!==T.version){let te=T.image;if(te===null)Ie("WebGLRenderer: Texture marked for update but no image data found.");else if(te.complete===!1)Ie("WebGLRenderer: Texture marked for update but image is incomplete");else{Ct(F,T,y);return}}else T.isExternalTexture&&(F.__webglTexture=T.sourceTexture?T.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,F.__webglTexture,n.TEXTURE0+y)}function xe(T,y){let F=i.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&F.__version!==T.version){Ct(F,T,y);return}else T.isExternalTexture&&(F.__webglTexture=T.sourceTexture?T.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,F.__webglTexture,n.TEXTURE0+y)}function Ee(T,y){let F=i.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&F.__version!==T.version){Ct(F,T,y);return}t.bindTexture(n.TEXTURE_3D,F.__webglTexture,n.TEXTURE0+y)}function ge(T,y){let F=i.get(T);if(T.version>0&&F.__version!==T.version){ln(F,T,y);return}t.bindTexture(n.TEXTURE_CUBE_MAP,F.__webglTexture,n.TEXTURE0+y)}let Oe={[Yo]:n.REPEAT,[Pn]:n.CLAMP_TO_EDGE,[Zo]:n.MIRRORED_REPEAT},Mt={[Vt]:n.NEAREST,[Qf]:n.NEAREST_MIPMAP_NEAREST,[ua]:n.NEAREST_MIPMAP_LINEAR,[mt]:n.LINEAR,[xl]:n.LINEAR_MIPMAP_NEAREST,[Ai]:n.LINEAR_MIPMAP_LINEAR},Re={[np]:n.NEVER,[ju]:n.ALWAYS,[ip]:n.LESS,[Ku]:n.LEQUAL,[sp]:n.EQUAL,[Qu]:n.GEQUAL,[rp]:n.GREATER,[ap]:n.NOTEQUAL};function nt(T,y){if(y.type===Sn&&e.has("OES_texture_float_linear")===!1&&(y.magFilter===mt||y.magFilter===xl||y.magFilter===ua||y.magFilter===Ai||y.minFilter===mt||y.minFilter===xl||y.minFilter===ua||y.minFilter===Ai)&&Ie("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(T,n.TEXTURE_WRAP_S,Oe[y.wrapS]),n.texParameteri(T,n.TEXTURE_WRAP_T,Oe[y.wrapT]),(T===n.TEXTURE_3D||T===n.TEXTURE_2D_ARRAY)&&n.texParameteri(T,n.TEXTURE_WRAP_R,Oe[y.wrapR]),n.texParameteri(T,n.TEXTURE_MAG_FILTER,Mt[y.magFilter]),n.texParameteri(T,n.TEXTURE_MIN_FILTER,Mt[y.minFilter]),y.compareFunction&&(n.texParameteri(T,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(T,n.TEXTURE_COMPARE_FUNC,Re[y.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===Vt||y.minFilter!==ua&&y.minFilter!==Ai||y.type===Sn&&e.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||i.get(y).__currentAnisotropy){let F=e.get("EXT_texture_filter_anisotropic");n.texParameterf(T,F.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),i.get(y).__currentAnisotropy=y.anisotropy}}}function at(T,y){let F=!1;T.__webglInit===void 0&&(T.__webglInit=!0,y.addEventListener("dispose",D),B(y));let te=y.source,Q=h.get(te);Q===void 0&&(Q={},h.set(te,Q));let re=Z(y);if(re!==T.__cacheKey){Q[re]===void 0&&(Q[re]={texture:n.createTexture(),usedTimes:0},a.memory.textures++,F=!0),Q[re].usedTimes++;let ue=Q[T.__cacheKey];ue!==void 0&&(Q[T.__cacheKey].usedTimes--,ue.usedTimes===0&&G(y)),T.__cacheKey=re,T.__webglTexture=Q[re].texture}return F}function Ge(T,y,F){return Math.floor(Math.floor(T/F)/y)}function Ht(T,y,F,te){let re=T.updateRanges;if(re.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,y.width,y.height,F,te,y.data);else{re.sort((R,J)=>R.start-J.start);let ue=0;for(let R=1;R<re.length;R++){let J=re[ue],W=re[R],le=J.start+J.count,se=Ge(W.start,y.width,4),ae=Ge(J.start,y.width,4);W.start<=le+1&&se===ae&&Ge(W.start+W.count-1,y.width,4)===se?J.count=Math.max(J.count,W.start+W.count-J.start):(++ue,re[ue]=W)}re.length=ue+1;let $=t.getParameter(n.UNPACK_ROW_LENGTH),Y=t.getParameter(n.UNPACK_SKIP_PIXELS),oe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,y.width);for(let R=0,J=re.length;R<J;R++){let W=re[R],le=Math.floor(W.start/4),se=Math.ceil(W.count/4),ae=le%y.width,we=Math.floor(le/y.width),ze=se,ie=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,ae),t.pixelStorei(n.UNPACK_SKIP_ROWS,we),t.texSubImage2D(n.TEXTURE_2D,0,ae,we,ze,ie,F,te,y.data)}T.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,$),t.pixelStorei(n.UNPACK_SKIP_PIXELS,Y),t.pixelStorei(n.UNPACK_SKIP_ROWS,oe)}}function Ct(T,y,F){let te=n.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(te=n.TEXTURE_2D_ARRAY),y.isData3DTexture&&(te=n.TEXTURE_3D);let Q=at(T,y),re=y.source;t.bindTexture(te,T.__webglTexture,n.TEXTURE0+F);let ue=i.get(re);if(re.version!==ue.__version||Q===!0){if(t.activeTexture(n.TEXTURE0+F),(typeof ImageBitmap<"u"&&y.image instanceof ImageBitmap)===!1){let ie=Xe.getPrimaries(Xe.workingColorSpace),Ae=y.colorSpace===Ci?null:Xe.getPrimaries(y.colorSpace),Be=y.colorSpace===Ci||ie===Ae?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Be)}t.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment);let Y=M(y.image,!1,s.maxTextureSize);Y=Ce(y,Y);let oe=r.convert(y.format,y.colorSpace),R=r.convert(y.type),J=E(y.internalFormat,oe,R,y.normalized,y.colorSpace,y.isVideoTexture);nt(te,y);let W,le=y.mipmaps,se=y.isVideoTexture!==!0,ae=ue.__version===void 0||Q===!0,we=re.dataReady,ze=w(y,Y);if(y.isDepthTexture)J=v(y.format===Ei,y.type),ae&&(se?t.texStorage2D(n.TEXTURE_2D,1,J,Y.width,Y.height):t.texImage2D(n.TEXTURE_2D,0,J,Y.width,Y.height,0,oe,R,null));else if(y.isDataTexture)if(le.length>0){se&&ae&&t.texStorage2D(n.TEXTURE_2D,ze,J,le[0].width,le[0].height);for(let ie=0,Ae=le.length;ie<Ae;ie++)W=le[ie],se?we&&t.texSubImage2D(n.TEXTURE_2D,ie,0,0,W.width,W.height,oe,R,W.data):t.texImage2D(n.TEXTURE_2D,ie,J,W.width,W.height,0,oe,R,W.data);y.generateMipmaps=!1}else se?(ae&&t.texStorage2D(n.TEXTURE_2D,ze,J,Y.width,Y.height),we&&Ht(y,Y,oe,R)):t.texImage2D(n.TEXTURE_2D,0,J,Y.width,Y.height,0,oe,R,Y.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){se&&ae&&t.texStorage3D(n.TEXTURE_2D_ARRAY,ze,J,le[0].width,le[0].height,Y.depth);for(let ie=0,Ae=le.length;ie<Ae;ie++)if(W=le[ie],y.format!==pn)if(oe!==null)if(se){if(we)if(y.layerUpdates.size>0){let Be=rh(W.width,W.height,y.format,y.type);for(let fe of y.layerUpdates){let it=W.data.subarray(fe*Be/W.data.BYTES_PER_ELEMENT,(fe+1)*Be/W.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ie,0,0,fe,W.width,W.height,1,oe,it)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ie,0,0,0,W.width,W.height,Y.depth,oe,W.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ie,J,W.width,W.height,Y.depth,0,W.data,0,0);else Ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else se?we&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ie,0,0,0,W.width,W.height,Y.depth,oe,R,W.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ie,J,W.width,W.height,Y.depth,0,oe,R,W.data);y.layerUpdates.size>0&&y.clearLayerUpdates()}else{se&&ae&&t.texStorage2D(n.TEXTURE_2D,ze,J,le[0].width,le[0].height);for(let ie=0,Ae=le.length;ie<Ae;ie++)W=le[ie],y.format!==pn?oe!==null?se?we&&t.compressedTexSubImage2D(n.TEXTURE_2D,ie,0,0,W.width,W.height,oe,W.data):t.compressedTexImage2D(n.TEXTURE_2D,ie,J,W.width,W.height,0,W.data):Ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):se?we&&t.texSubImage2D(n.TEXTURE_2D,ie,0,0,W.width,W.height,oe,R,W.data):t.texImage2D(n.TEXTURE_2D,ie,J,W.width,W.height,0,oe,R,W.data)}else if(y.isDataArrayTexture)if(se){if(ae&&t.texStorage3D(n.TEXTURE_2D_ARRAY,ze,J,Y.width,Y.height,Y.depth),we)if(y.layerUpdates.size>0){let ie=rh(Y.width,Y.height,y.format,y.type);for(let Ae of y.layerUpdates){let Be=Y.data.subarray(Ae*ie/Y.data.BYTES_PER_ELEMENT,(Ae+1)*ie/Y.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ae,Y.width,Y.height,1,oe,R,Be)}y.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,Y.width,Y.height,Y.depth,oe,R,Y.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,J,Y.width,Y.height,Y.depth,0,oe,R,Y.data);else if(y.isData3DTexture)se?(ae&&t.texStorage3D(n.TEXTURE_3D,ze,J,Y.width,Y.height,Y.depth),we&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,Y.width,Y.height,Y.depth,oe,R,Y.data)):t.texImage3D(n.TEXTURE_3D,0,J,Y.width,Y.height,Y.depth,0,oe,R,Y.data);else if(y.isFramebufferTexture){if(ae)if(se)t.texStorage2D(n.TEXTURE_2D,ze,J,Y.width,Y.height);else{let ie=Y.width,Ae=Y.height;for(let Be=0;Be<ze;Be++)t.texImage2D(n.TEXTURE_2D,Be,J,ie,Ae,0,oe,R,null),ie>>=1,Ae>>=1}}else if(y.isHTMLTexture){if("texElementImage2D"in n){let ie=n.canvas;if(ie.hasAttribute("layoutsubtree")||ie.setAttribute("layoutsubtree","true"),Y.parentNode!==ie){ie.appendChild(Y),m.add(y),ie.onpaint=Ae=>{let Be=Ae.changedElements;for(let fe of m)Be.includes(fe.image)&&(fe.needsUpdate=!0)},ie.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,Y);else{let Be=n.RGBA,fe=n.RGBA,it=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Be,fe,it,Y)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(le.length>0){if(se&&ae){let ie=De(le[0]);t.texStorage2D(n.TEXTURE_2D,ze,J,ie.width,ie.height)}for(let ie=0,Ae=le.length;ie<Ae;ie++)W=le[ie],se?we&&t.texSubImage2D(n.TEXTURE_2D,ie,0,0,oe,R,W):t.texImage2D(n.TEXTURE_2D,ie,J,oe,R,W);y.generateMipmaps=!1}else if(se){if(ae){let ie=De(Y);t.texStorage2D(n.TEXTURE_2D,ze,J,ie.width,ie.height)}we&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,oe,R,Y)}else t.texImage2D(n.TEXTURE_2D,0,J,oe,R,Y);A(y)&&y.mipmapsAutoUpdate===!0&&S(te),ue.__version=re.version,y.onUpdate&&y.onUpdate(y)}T.__version=y.version}function ln(T,y,F){if(y.image.length!==6)return;let te=at(T,y),Q=y.source;t.bindTexture(n.TEXTURE_CUBE_MAP,T.__webglTexture,n.TEXTURE0+F);let re=i.get(Q);if(Q.version!==re.__version||te===!0){t.activeTexture(n.TEXTURE0+F);let ue=Xe.getPrimaries(Xe.workingColorSpace),$=y.colorSpace===Ci?null:Xe.getPrimaries(y.colorSpace),Y=y.colorSpace===Ci||ue===$?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Y);let oe=y.isCompressedTexture||y.image[0].isCompressedTexture,R=y.image[0]&&y.image[0].isDataTexture,J=[];for(let fe=0;fe<6;fe++)!oe&&!R?J[fe]=M(y.image[fe],!0,s.maxCubemapSize):J[fe]=R?y.image[fe].image:y.image[fe],J[fe]=Ce(y,J[fe]);let W=J[0],le=r.convert(y.format,y.colorSpace),se=r.convert(y.type),ae=E(y.internalFormat,le,se,y.normalized,y.colorSpace),we=y.isVideoTexture!==!0,ze=re.__version===void 0||te===!0,ie=Q.dataReady,Ae=w(y,W);nt(n.TEXTURE_CUBE_MAP,y);let Be;if(y.isDepthTexture){if(ae=v(y.format===Ei,y.type),ze)if(we)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,ae,W.width,W.height);else for(let fe=0;fe<6;fe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,0,ae,W.width,W.height,0,le,se,null)}else if(oe){we&&ze&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Ae,ae,W.width,W.height);for(let fe=0;fe<6;fe++){Be=J[fe].mipmaps;for(let it=0;it<Be.length;it++){let Ot=Be[it];y.format!==pn?le!==null?we?ie&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,it,0,0,Ot.width,Ot.height,le,Ot.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,it,ae,Ot.width,Ot.height,0,Ot.data):Ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):we?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,it,0,0,Ot.width,Ot.height,le,se,Ot.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,it,ae,Ot.width,Ot.height,0,le,se,Ot.data)}}}else{if(Be=y.mipmaps,we&&ze){Be.length>0&&Ae++;let fe=De(J[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Ae,ae,fe.width,fe.height)}for(let fe=0;fe<6;fe++)if(R){we?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,0,0,0,J[fe].width,J[fe].height,le,se,J[fe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,0,ae,J[fe].width,J[fe].height,0,le,se,J[fe].data);for(let it=0;it<Be.length;it++){let Ii=Be[it].image[fe].image;we?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,it+1,0,0,Ii.width,Ii.height,le,se,Ii.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,it+1,ae,Ii.width,Ii.height,0,le,se,Ii.data)}}else{we?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,0,0,0,le,se,J[fe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,0,ae,le,se,J[fe]);for(let it=0;it<Be.length;it++){let Ot=Be[it];we?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,it+1,0,0,le,se,Ot.image[fe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,it+1,ae,le,se,Ot.image[fe])}}}A(y)&&y.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),re.__version=Q.version,y.onUpdate&&y.onUpdate(y)}T.__version=y.version}function gt(T,y,F,te,Q,re){let ue=r.convert(F.format,F.colorSpace),$=r.convert(F.type),Y=E(F.internalFormat,ue,$,F.normalized,F.colorSpace),oe=i.get(y),R=i.get(F);if(R.__renderTarget=y,!oe.__hasExternalTextures){let J=Math.max(1,y.width>>re),W=Math.max(1,y.height>>re);Q===n.TEXTURE_3D||Q===n.TEXTURE_2D_ARRAY?t.texImage3D(Q,re,Y,J,W,y.depth,0,ue,$,null):t.texImage2D(Q,re,Y,J,W,0,ue,$,null)}t.bindFramebuffer(n.FRAMEBUFFER,T),de(y)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,te,Q,R.__webglTexture,0,dt(y)):(Q===n.TEXTURE_2D||Q>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,te,Q,R.__webglTexture,re),t.bindFramebuffer(n.FRAMEBUFFER,null)}function $n(T,y,F){if(n.bindRenderbuffer(n.RENDERBUFFER,T),y.depthBuffer){let te=y.depthTexture,Q=te&&te.isDepthTexture?te.type:null,re=v(y.stencilBuffer,Q),ue=y.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;de(y)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,dt(y),re,y.width,y.height):F?n.renderbufferStorageMultisample(n.RENDERBUFFER,dt(y),re,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,re,y.width,y.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ue,n.RENDERBUFFER,T)}else{let te=y.textures;for(let Q=0;Q<te.length;Q++){let re=te[Q],ue=r.convert(re.format,re.colorSpace),$=r.convert(re.type),Y=E(re.internalFormat,ue,$,re.normalized,re.colorSpace);de(y)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,dt(y),Y,y.width,y.height):F?n.renderbufferStorageMultisample(n.RENDERBUFFER,dt(y),Y,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,Y,y.width,y.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Ft(T,y,F){let te=y.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,T),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Q=i.get(y.depthTexture);Q.__renderTarget=y;let re=te?y.depthTexture.image[0]:y.depthTexture.image;(!Q.__webglTexture||re.width!==y.width||re.height!==y.height)&&(re.width=y.width,re.height=y.height,y.depthTexture.needsUpdate=!0),te?ge(y.depthTexture,0):me(y.depthTexture,0);let ue=Q.__webglTexture,$=dt(y),Y=te?n.TEXTURE_CUBE_MAP_POSITIVE_X+F:n.TEXTURE_2D,oe=y.depthTexture.format===Ei?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(y.depthTexture.format===Si)de(y)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,oe,Y,ue,0,$):n.framebufferTexture2D(n.FRAMEBUFFER,oe,Y,ue,0);else if(y.depthTexture.format===Ei)de(y)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,oe,Y,ue,0,$):n.framebufferTexture2D(n.FRAMEBUFFER,oe,Y,ue,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function wn(T){let y=i.get(T),F=T.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==T.depthTexture){let te=T.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),te){let Q=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,te.removeEventListener("dispose",Q)};te.addEventListener("dispose",Q),y.__depthDisposeCallback=Q}y.__boundDepthTexture=te}if(T.depthTexture&&!y.__autoAllocateDepthBuffer)if(F)for(let te=0;te<6;te++)Ft(y.__webglFramebuffer[te],T,te);else T.texture.mipmaps.length>0?Ft(y.__webglFramebuffer[0],T,0):Ft(y.__webglFramebuffer,T,0);else if(F){y.__webglDepthbuffer=[];for(let te=0;te<6;te++)if(t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[te]),y.__webglDepthbuffer[te]===void 0)y.__webglDepthbuffer[te]=n.createRenderbuffer(),$n(y.__webglDepthbuffer[te],T,!1);else{let Q=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,re=y.__webglDepthbuffer[te];n.bindRenderbuffer(n.RENDERBUFFER,re),n.framebufferRenderbuffer(n.FRAMEBUFFER,Q,n.RENDERBUFFER,re)}}else if(T.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=n.createRenderbuffer(),$n(y.__webglDepthbuffer,T,!1);else{let Q=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,re=y.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,re),n.framebufferRenderbuffer(n.FRAMEBUFFER,Q,n.RENDERBUFFER,re)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Tn(T,y,F){let te=i.get(T);y!==void 0&&gt(te.__webglFramebuffer,T,T.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),F!==void 0&&wn(T)}function An(T){let y=T.texture,F=i.get(T),te=i.get(y);T.addEventListener("dispose",k),B(T);let Q=T.textures,re=T.isWebGLCubeRenderTarget===!0,ue=Q.length>1;if(ue||(te.__webglTexture===void 0&&(te.__webglTexture=n.createTexture()),te.__version=y.version,a.memory.textures++),re){F.__webglFramebuffer=[];for(let $=0;$<6;$++)if(y.mipmaps.length>0){F.__webglFramebuffer[$]=[];for(let Y=0;Y<y.mipmaps.length;Y++)F.__webglFramebuffer[$][Y]=n.createFramebuffer()}else F.__webglFramebuffer[$]=n.createFramebuffer()}else{if(y.mipmaps.length>0){F.__webglFramebuffer=[];for(let $=0;$<y.mipmaps.length;$++)F.__webglFramebuffer[$]=n.createFramebuffer()}else F.__webglFramebuffer=n.createFramebuffer();if(ue)for(let $=0,Y=Q.length;$<Y;$++){let oe=i.get(Q[$]);oe.__webglTexture===void 0&&(oe.__webglTexture=n.createTexture(),a.memory.textures++)}if(T.samples>0&&de(T)===!1){F.__webglMultisampledFramebuffer=n.createFramebuffer(),F.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,F.__webglMultisampledFramebuffer);for(let $=0;$<Q.length;$++){let Y=Q[$];F.__webglColorRenderbuffer[$]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,F.__webglColorRenderbuffer[$]);let oe=r.convert(Y.format,Y.colorSpace),R=r.convert(Y.type),J=E(Y.internalFormat,oe,R,Y.normalized,Y.colorSpace,T.isXRRenderTarget===!0),W=dt(T);n.renderbufferStorageMultisample(n.RENDERBUFFER,W,J,T.width,T.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+$,n.RENDERBUFFER,F.__webglColorRenderbuffer[$])}n.bindRenderbuffer(n.RENDERBUFFER,null),T.depthBuffer&&(F.__webglDepthRenderbuffer=n.createRenderbuffer(),$n(F.__webglDepthRenderbuffer,T,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(re){t.bindTexture(n.TEXTURE_CUBE_MAP,te.__webglTexture),nt(n.TEXTURE_CUBE_MAP,y);for(let $=0;$<6;$++)if(y.mipmaps.length>0)for(let Y=0;Y<y.mipmaps.length;Y++)gt(F.__webglFramebuffer[$][Y],T,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+$,Y);else gt(F.__webglFramebuffer[$],T,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+$,0);A(y)?S(n.TEXTURE_CUBE_MAP):y.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}else if(ue){for(let $=0,Y=Q.length;$<Y;$++){let oe=Q[$],R=i.get(oe),J=n.TEXTURE_2D;(T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(J=T.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(J,R.__webglTexture),nt(J,oe),gt(F.__webglFramebuffer,T,oe,n.COLOR_ATTACHMENT0+$,J,0),A(oe)&&S(J)}t.unbindTexture()}else{let $=n.TEXTURE_2D;if((T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&($=T.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture($,te.__webglTexture),nt($,y),y.mipmaps.length>0)for(let Y=0;Y<y.mipmaps.length;Y++)gt(F.__webglFramebuffer[Y],T,y,n.COLOR_ATTACHMENT0,$,Y);else gt(F.__webglFramebuffer,T,y,n.COLOR_ATTACHMENT0,$,0);A(y)?S($):y.mipmaps.length>0&&n.texParameteri($,n.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}T.depthBuffer&&wn(T)}function N(T){let y=T.textures;for(let F=0,te=y.length;F<te;F++){let Q=y[F];if(A(Q)&&Q.mipmapsAutoUpdate===!0){let re=C(T),ue=i.get(Q).__webglTexture;t.bindTexture(re,ue),S(re),t.unbindTexture()}}}let En=[];function ht(T){if(T.samples>0){if(de(T)===!1){let y=T.textures,F=T.width,te=T.height,Q=n.COLOR_BUFFER_BIT,re=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ue=i.get(T),$=y.length>1;if($)for(let oe=0;oe<y.length;oe++)t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+oe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+oe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ue.__webglMultisampledFramebuffer),T.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ue.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ue.__webglFramebuffer);for(let oe=0;oe<y.length;oe++){if(T.resolveDepthBuffer&&(T.depthBuffer&&(Q|=n.DEPTH_BUFFER_BIT),T.stencilBuffer&&T.resolveStencilBuffer&&(Q|=n.STENCIL_BUFFER_BIT)),$){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ue.__webglColorRenderbuffer[oe]);let R=i.get(y[oe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,R,0)}n.blitFramebuffer(0,0,F,te,0,0,F,te,Q,n.NEAREST),l===!0&&(En.length=0,En.push(n.COLOR_ATTACHMENT0+oe),T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&En.push(re),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,En))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),$)for(let oe=0;oe<y.length;oe++){t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+oe,n.RENDERBUFFER,ue.__webglColorRenderbuffer[oe]);let R=i.get(y[oe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+oe,n.TEXTURE_2D,R,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ue.__webglMultisampledFramebuffer)}else if(T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&l){let y=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[y])}}}function dt(T){return Math.min(s.maxSamples,T.samples)}function de(T){let y=i.get(T);return T.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Rt(T){let y=a.render.frame;u.get(T)!==y&&(u.set(T,y),T.update())}function Ce(T,y){let F=T.colorSpace,te=T.format,Q=T.type;return T.isCompressedTexture===!0||T.isVideoTexture===!0||F!==Zr&&F!==Ci&&(Xe.getTransfer(F)===tt?(te!==pn||Q!==jt)&&Ie("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Le("WebGLTextures: Unsupported texture color space:",F)),y}function De(T){return typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement?(c.width=T.naturalWidth||T.width,c.height=T.naturalHeight||T.height):typeof VideoFrame<"u"&&T instanceof VideoFrame?(c.width=T.displayWidth,c.height=T.displayHeight):(c.width=T.width,c.height=T.height),c}this.allocateTextureUnit=Ue,this.resetTextureUnits=j,this.getTextureUnits=ee,this.setTextureUnits=Me,this.setTexture2D=me,this.setTexture2DArray=xe,this.setTexture3D=Ee,this.setTextureCube=ge,this.rebindTextures=Tn,this.setupRenderTarget=An,this.updateRenderTargetMipmap=N,this.updateMultisampleRenderTarget=ht,this.setupDepthRenderbuffer=wn,this.setupFrameBufferTexture=gt,this.useMultisampledRTT=de,this.dispose=q}function Ib(n,e){function t(i,s=Ci){let r,a=Xe.getTransfer(s);if(i===jt)return n.UNSIGNED_BYTE;if(i===bl)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Ml)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Xu)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===qu)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Hu)return n.BYTE;if(i===Wu)return n.SHORT;if(i===pr)return n.UNSIGNED_SHORT;if(i===yl)return n.INT;if(i===Xn)return n.UNSIGNED_INT;if(i===Sn)return n.FLOAT;if(i===qn)return n.HALF_FLOAT;if(i===$u)return n.ALPHA;if(i===Yu)return n.RGB;if(i===pn)return n.RGBA;if(i===Si)return n.DEPTH_COMPONENT;if(i===Ei)return n.DEPTH_STENCIL;if(i===Zu)return n.RED;if(i===Sl)return n.RED_INTEGER;if(i===ri)return n.RG;if(i===wl)return n.RG_INTEGER;if(i===Tl)return n.RGBA_INTEGER;if(i===ha||i===da||i===fa||i===pa)if(a===tt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ha)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===da)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===fa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===pa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ha)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===da)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===fa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===pa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Al||i===El||i===Cl||i===Rl)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Al)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===El)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Cl)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Rl)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Pl||i===Il||i===Ll||i===Nl||i===Dl||i===ma||i===Ul)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Pl||i===Il)return a===tt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ll)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Nl)return r.COMPRESSED_R11_EAC;if(i===Dl)return r.COMPRESSED_SIGNED_R11_EAC;if(i===ma)return r.COMPRESSED_RG11_EAC;if(i===Ul)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Fl||i===Ol||i===Bl||i===kl||i===zl||i===Vl||i===Gl||i===Hl||i===Wl||i===Xl||i===ql||i===$l||i===Yl||i===Zl)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Fl)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ol)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Bl)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===kl)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===zl)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Vl)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Gl)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Hl)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Wl)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Xl)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===ql)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===$l)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Yl)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Zl)return a===tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Jl||i===Kl||i===Ql)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Jl)return a===tt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Kl)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Ql)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===jl||i===ec||i===ga||i===tc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===jl)return r.COMPRESSED_RED_RGTC1_EXT;if(i===ec)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ga)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===tc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===As?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var Lb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Nb=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,ph=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new ra(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new ni({vertexShader:Lb,fragmentShader:Nb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new qt(new aa(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},mh=class extends jn{constructor(e,t){super();let i=this,s=null,r=1,a=null,o="local-floor",l=1,c=null,u=null,m=null,d=null,h=null,_=null,x=typeof XRWebGLBinding<"u",p=new ph,f={},M=t.getContextAttributes(),A=null,S=null,C=[],E=[],v=new Ye,w=null,B=null,L=new an;L.viewport=new xt;let D=new an;D.viewport=new xt;let k=[L,D],H=new gl,I=null,q=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Z){let me=C[Z];return me===void 0&&(me=new or,C[Z]=me),me.getTargetRaySpace()},this.getControllerGrip=function(Z){let me=C[Z];return me===void 0&&(me=new or,C[Z]=me),me.getGripSpace()},this.getHand=function(Z){let me=C[Z];return me===void 0&&(me=new or,C[Z]=me),me.getHandSpace()};function K(Z){let me=E.indexOf(Z.inputSource);if(me===-1)return;let xe=C[me];xe!==void 0&&(xe.update(Z.inputSource,Z.frame,c||a),xe.dispatchEvent({type:Z.type,data:Z.inputSource}))}function G(){s.removeEventListener("select",K),s.removeEventListener("selectstart",K),s.removeEventListener("selectend",K),s.removeEventListener("squeeze",K),s.removeEventListener("squeezestart",K),s.removeEventListener("squeezeend",K),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",ne);for(let Z=0;Z<C.length;Z++){let me=E[Z];me!==null&&(E[Z]=null,C[Z].disconnect(me))}I=null,q=null,p.reset();for(let Z in f)delete f[Z];if(e.setRenderTarget(A),h=null,d=null,m=null,s=null,S=null,Ue.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(v.width,v.height,!1),B!==null){let Z=B.camera;Z.fov=B.fov,Z.zoom=B.zoom,Z.updateProjectionMatrix(),B=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Z){r=Z,i.isPresenting===!0&&Ie("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Z){o=Z,i.isPresenting===!0&&Ie("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(Z){c=Z},this.getBaseLayer=function(){return d!==null?d:h},this.getBinding=function(){return m===null&&x&&(m=new XRWebGLBinding(s,t)),m},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(Z){if(s=Z,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",K),s.addEventListener("selectstart",K),s.addEventListener("selectend",K),s.addEventListener("squeeze",K),s.addEventListener("squeezestart",K),s.addEventListener("squeezeend",K),s.addEventListener("end",G),s.addEventListener("inputsourceschange",ne),M.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(v),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let xe=null,Ee=null,ge=null;M.depth&&(ge=M.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,xe=M.stencil?Ei:Si,Ee=M.stencil?As:Xn);let Oe={colorFormat:t.RGBA8,depthFormat:ge,scaleFactor:r};m=this.getBinding(),d=m.createProjectionLayer(Oe),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),S=new Gt(d.textureWidth,d.textureHeight,{format:pn,type:jt,depthTexture:new Ti(d.textureWidth,d.textureHeight,Ee,void 0,void 0,void 0,void 0,void 0,void 0,xe),stencilBuffer:M.stencil,colorSpace:e.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xe={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};h=new XRWebGLLayer(s,t,xe),s.updateRenderState({baseLayer:h}),e.setPixelRatio(1),e.setSize(h.framebufferWidth,h.framebufferHeight,!1),S=new Gt(h.framebufferWidth,h.framebufferHeight,{format:pn,type:jt,colorSpace:e.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),Ue.setContext(s),Ue.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function ne(Z){for(let me=0;me<Z.removed.length;me++){let xe=Z.removed[me],Ee=E.indexOf(xe);Ee>=0&&(E[Ee]=null,C[Ee].disconnect(xe))}for(let me=0;me<Z.added.length;me++){let xe=Z.added[me],Ee=E.indexOf(xe);if(Ee===-1){for(let Oe=0;Oe<C.length;Oe++)if(Oe>=E.length){E.push(xe),Ee=Oe;break}else if(E[Oe]===null){E[Oe]=xe,Ee=Oe;break}if(Ee===-1)break}let ge=C[Ee];ge&&ge.connect(xe)}}function X(Z,me){me===null?Z.matrixWorld.copy(Z.matrix):Z.matrixWorld.multiplyMatrices(me.matrixWorld,Z.matrix),Z.matrixWorldInverse.copy(Z.matrixWorld).invert()}this.updateCamera=function(Z){if(s===null)return;let me=Z.near,xe=Z.far;p.texture!==null&&(p.depthNear>0&&(me=p.depthNear),p.depthFar>0&&(xe=p.depthFar)),H.near=D.near=L.near=me,H.far=D.far=L.far=xe,(I!==H.near||q!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),I=H.near,q=H.far),H.layers.mask=Z.layers.mask|6,L.layers.mask=H.layers.mask&-5,D.layers.mask=H.layers.mask&-3;let Ee=Z.parent,ge=H.cameras;X(H,Ee);for(let Oe=0;Oe<ge.length;Oe++)X(ge[Oe],Ee);H.projectionMatrix.copy(L.projectionMatrix),H.projectionMatrixInverse.copy(L.projectionMatrixInverse),B===null&&Z.isPerspectiveCamera&&(B={camera:Z,fov:Z.fov,zoom:Z.zoom}),j(Z,H,Ee)};function j(Z,me,xe){xe===null?Z.matrix.copy(me.matrixWorld):(Z.matrix.copy(xe.matrixWorld),Z.matrix.invert(),Z.matrix.multiply(me.matrixWorld)),Z.matrix.decompose(Z.position,Z.quaternion,Z.scale),Z.updateMatrixWorld(!0),Z.projectionMatrix.copy(me.projectionMatrix),Z.projectionMatrixInverse.copy(me.projectionMatrixInverse),Z.isPerspectiveCamera&&(Z.fov=Ko*2*Math.atan(1/Z.projectionMatrix.elements[5]),Z.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(d===null&&h===null))return l},this.setFoveation=function(Z){l=Z,d!==null&&(d.fixedFoveation=Z),h!==null&&h.fixedFoveation!==void 0&&(h.fixedFoveation=Z)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(H)},this.getCameraTexture=function(Z){return f[Z]};let ee=null;function Me(Z,me){if(u=me.getViewerPose(c||a),_=me,u!==null){let xe=u.views;h!==null&&(e.setRenderTargetFramebuffer(S,h.framebuffer),e.setRenderTarget(S));let Ee=!1;xe.length!==H.cameras.length&&(H.cameras.length=0,Ee=!0);for(let Re=0;Re<xe.length;Re++){let nt=xe[Re],at=null;if(h!==null)at=h.getViewport(nt);else{let Ht=m.getViewSubImage(d,nt);at=Ht.viewport,Re===0&&(e.setRenderTargetTextures(S,Ht.colorTexture,Ht.depthStencilTexture),e.setRenderTarget(S))}let Ge=k[Re];Ge===void 0&&(Ge=new an,Ge.layers.enable(Re),Ge.viewport=new xt,k[Re]=Ge),Ge.matrix.fromArray(nt.transform.matrix),Ge.matrix.decompose(Ge.position,Ge.quaternion,Ge.scale),Ge.projectionMatrix.fromArray(nt.projectionMatrix),Ge.projectionMatrixInverse.copy(Ge.projectionMatrix).invert(),Ge.viewport.set(at.x,at.y,at.width,at.height),Re===0&&(H.matrix.copy(Ge.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),Ee===!0&&H.cameras.push(Ge)}let ge=s.enabledFeatures;if(ge&&ge.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){m=i.getBinding();let Re=m.getDepthInformation(xe[0]);Re&&Re.isValid&&Re.texture&&p.init(Re,s.renderState)}if(ge&&ge.includes("camera-access")&&x){e.state.unbindTexture(),m=i.getBinding();for(let Re=0;Re<xe.length;Re++){let nt=xe[Re].camera;if(nt){let at=f[nt];at||(at=new ra,f[nt]=at);let Ge=m.getCameraImage(nt);at.sourceTexture=Ge}}}}for(let xe=0;xe<C.length;xe++){let Ee=E[xe],ge=C[xe];Ee!==null&&ge!==void 0&&ge.update(Ee,me,c||a)}ee&&ee(Z,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),_=null}let Ue=new Bp;Ue.setAnimationLoop(Me),this.setAnimationLoop=function(Z){ee=Z},this.dispose=function(){}}},Db=new lt,Yp=new Ne;Yp.set(-1,0,0,0,1,0,0,0,1);function Ub(n,e){function t(p,f){p.matrixAutoUpdate===!0&&p.updateMatrix(),f.value.copy(p.matrix)}function i(p,f){f.color.getRGB(p.fogColor.value,nh(n)),f.isFog?(p.fogNear.value=f.near,p.fogFar.value=f.far):f.isFogExp2&&(p.fogDensity.value=f.density)}function s(p,f,M,A,S){f.isNodeMaterial?f.uniformsNeedUpdate=!1:f.isMeshBasicMaterial?r(p,f):f.isMeshLambertMaterial?(r(p,f),f.envMap&&(p.envMapIntensity.value=f.envMapIntensity)):f.isMeshToonMaterial?(r(p,f),m(p,f)):f.isMeshPhongMaterial?(r(p,f),u(p,f),f.envMap&&(p.envMapIntensity.value=f.envMapIntensity)):f.isMeshStandardMaterial?(r(p,f),d(p,f),f.isMeshPhysicalMaterial&&h(p,f,S)):f.isMeshMatcapMaterial?(r(p,f),_(p,f)):f.isMeshDepthMaterial?r(p,f):f.isMeshDistanceMaterial?(r(p,f),x(p,f)):f.isMeshNormalMaterial?r(p,f):f.isLineBasicMaterial?(a(p,f),f.isLineDashedMaterial&&o(p,f)):f.isPointsMaterial?l(p,f,M,A):f.isSpriteMaterial?c(p,f):f.isShadowMaterial?(p.color.value.copy(f.color),p.opacity.value=f.opacity):f.isShaderMaterial&&(f.uniformsNeedUpdate=!1)}function r(p,f){p.opacity.value=f.opacity,f.color&&p.diffuse.value.copy(f.color),f.emissive&&p.emissive.value.copy(f.emissive).multiplyScalar(f.emissiveIntensity),f.map&&(p.map.value=f.map,t(f.map,p.mapTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,t(f.alphaMap,p.alphaMapTransform)),f.bumpMap&&(p.bumpMap.value=f.bumpMap,t(f.bumpMap,p.bumpMapTransform),p.bumpScale.value=f.bumpScale,f.side===on&&(p.bumpScale.value*=-1)),f.normalMap&&(p.normalMap.value=f.normalMap,t(f.normalMap,p.normalMapTransform),p.normalScale.value.copy(f.normalScale),f.side===on&&p.normalScale.value.negate()),f.displacementMap&&(p.displacementMap.value=f.displacementMap,t(f.displacementMap,p.displacementMapTransform),p.displacementScale.value=f.displacementScale,p.displacementBias.value=f.displacementBias),f.emissiveMap&&(p.emissiveMap.value=f.emissiveMap,t(f.emissiveMap,p.emissiveMapTransform)),f.specularMap&&(p.specularMap.value=f.specularMap,t(f.specularMap,p.specularMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest);let M=e.get(f),A=M.envMap,S=M.envMapRotation;A&&(p.envMap.value=A,p.envMapRotation.value.setFromMatrix4(Db.makeRotationFromEuler(S)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Yp),p.reflectivity.value=f.reflectivity,p.ior.value=f.ior,p.refractionRatio.value=f.refractionRatio),f.lightMap&&(p.lightMap.value=f.lightMap,p.lightMapIntensity.value=f.lightMapIntensity,t(f.lightMap,p.lightMapTransform)),f.aoMap&&(p.aoMap.value=f.aoMap,p.aoMapIntensity.value=f.aoMapIntensity,t(f.aoMap,p.aoMapTransform))}function a(p,f){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,f.map&&(p.map.value=f.map,t(f.map,p.mapTransform))}function o(p,f){p.dashSize.value=f.dashSize,p.totalSize.value=f.dashSize+f.gapSize,p.scale.value=f.scale}function l(p,f,M,A){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,p.size.value=f.size*M,p.scale.value=A*.5,f.map&&(p.map.value=f.map,t(f.map,p.uvTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,t(f.alphaMap,p.alphaMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest)}function c(p,f){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,p.rotation.value=f.rotation,f.map&&(p.map.value=f.map,t(f.map,p.mapTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,t(f.alphaMap,p.alphaMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest)}function u(p,f){p.specular.value.copy(f.specular),p.shininess.value=Math.max(f.shininess,1e-4)}function m(p,f){f.gradientMap&&(p.gradientMap.value=f.gradientMap)}function d(p,f){p.metalness.value=f.metalness,f.metalnessMap&&(p.metalnessMap.value=f.metalnessMap,t(f.metalnessMap,p.metalnessMapTransform)),p.roughness.value=f.roughness,f.roughnessMap&&(p.roughnessMap.value=f.roughnessMap,t(f.roughnessMap,p.roughnessMapTransform)),f.envMap&&(p.envMapIntensity.value=f.envMapIntensity)}function h(p,f,M){p.ior.value=f.ior,f.diffuseRoughness>0&&(p.diffuseRoughness.value=f.diffuseRoughness,f.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=f.diffuseRoughnessMap,t(f.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),f.sheen>0&&(p.sheenColor.value.copy(f.sheenColor).multiplyScalar(f.sheen),p.sheenRoughness.value=f.sheenRoughness,f.sheenColorMap&&(p.sheenColorMap.value=f.sheenColorMap,t(f.sheenColorMap,p.sheenColorMapTransform)),f.sheenRoughnessMap&&(p.sheenRoughnessMap.value=f.sheenRoughnessMap,t(f.sheenRoughnessMap,p.sheenRoughnessMapTransform))),f.clearcoat>0&&(p.clearcoat.value=f.clearcoat,p.clearcoatRoughness.value=f.clearcoatRoughness,f.clearcoatMap&&(p.clearcoatMap.value=f.clearcoatMap,t(f.clearcoatMap,p.clearcoatMapTransform)),f.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=f.clearcoatRoughnessMap,t(f.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),f.clearcoatNormalMap&&(p.clearcoatNormalMap.value=f.clearcoatNormalMap,t(f.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(f.clearcoatNormalScale),f.side===on&&p.clearcoatNormalScale.value.negate())),f.dispersion>0&&(p.dispersion.value=f.dispersion),f.retroreflectivity>0&&(p.retroreflectivity.value=f.retroreflectivity),f.iridescence>0&&(p.iridescence.value=f.iridescence,p.iridescenceIOR.value=f.iridescenceIOR,p.iridescenceThicknessMinimum.value=f.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=f.iridescenceThicknessMaximum,f.iridescenceMap&&(p.iridescenceMap.value=f.iridescenceMap,t(f.iridescenceMap,p.iridescenceMapTransform)),f.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=f.iridescenceThicknessMap,t(f.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),f.transmission>0&&(p.transmission.value=f.transmission,p.transmissionSamplerMap.value=M.texture,p.transmissionSamplerSize.value.set(M.width,M.height),f.transmissionMap&&(p.transmissionMap.value=f.transmissionMap,t(f.transmissionMap,p.transmissionMapTransform)),p.thickness.value=f.thickness,f.thicknessMap&&(p.thicknessMap.value=f.thicknessMap,t(f.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=f.attenuationDistance,p.attenuationColor.value.copy(f.attenuationColor)),f.anisotropy>0&&(p.anisotropyVector.value.set(f.anisotropy*Math.cos(f.anisotropyRotation),f.anisotropy*Math.sin(f.anisotropyRotation)),f.anisotropyMap&&(p.anisotropyMap.value=f.anisotropyMap,t(f.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=f.specularIntensity,p.specularColor.value.copy(f.specularColor),f.specularColorMap&&(p.specularColorMap.value=f.specularColorMap,t(f.specularColorMap,p.specularColorMapTransform)),f.specularIntensityMap&&(p.specularIntensityMap.value=f.specularIntensityMap,t(f.specularIntensityMap,p.specularIntensityMapTransform))}function _(p,f){f.matcap&&(p.matcap.value=f.matcap)}function x(p,f){let M=e.get(f).light;p.referencePosition.value.setFromMatrixPosition(M.matrixWorld),p.nearDistance.value=M.shadow.camera.near,p.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function Fb(n,e,t,i){let s={},r={};function a(M,A){let S=A.program;i.uniformBlockBinding(M,S,s[M.id])}function o(M,A){let S=s[M.id];S===void 0&&(_(M),S=l(M),s[M.id]=S,M.addEventListener("dispose",p));let C=A.program;i.updateUBOMapping(M,C);let E=e.render.frame;r[M.id]!==E&&(c(M),r[M.id]=E)}function l(M){let A=n.createBuffer(),S=M.__size,C=M.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,S,C),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function c(M){let A=s[M.id],S=M.uniforms,C=M.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let E=0,v=S.length;E<v;E++){let w=S[E];if(Array.isArray(w))for(let B=0,L=w.length;B<L;B++)u(w[B],E,B,C);else u(w,E,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(M,A,S,C){if(d(M,A,S,C)===!0){let E=M.__offset,v=M.value;if(Array.isArray(v)){let w=0;for(let B=0;B<v.length;B++){let L=v[B],D=x(L,!0);m(L,M.__data,w),w+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else m(v,M.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,M.__data)}}function m(M,A,S){typeof M=="number"||typeof M=="boolean"?A[S]=M:M.isMatrix3?(A[S]=M.elements[0],A[S+1]=M.elements[1],A[S+2]=M.elements[2],A[S+3]=0,A[S+4]=M.elements[3],A[S+5]=M.elements[4],A[S+6]=M.elements[5],A[S+7]=0,A[S+8]=M.elements[6],A[S+9]=M.elements[7],A[S+10]=M.elements[8],A[S+11]=0):ArrayBuffer.isView(M)?A.set(M.subarray(0,A.length-S),S):M.toArray(A,S)}function d(M,A,S,C){let E=M.value,v=A+"_"+S;if(Array.isArray(E)){C[v]===void 0&&(C[v]=[]);let w=C[v],B=!1;for(let L=0;L<E.length;L++)h(E[L],w,L)===!0&&(B=!0);return B}return h(E,C,v)}function h(M,A,S){if(A[S]===void 0)return typeof M=="number"||typeof M=="boolean"?A[S]=M:ArrayBuffer.isView(M)?A[S]=M.slice():A[S]=M.clone(),!0;{let C=A[S];if(typeof M=="number"||typeof M=="boolean"){if(C!==M)return A[S]=M,!0}else{if(ArrayBuffer.isView(M))return!0;if(C.equals(M)===!1)return C.copy(M),!0}}return!1}function _(M){let A=M.uniforms,S=0,C=16;for(let v=0,w=A.length;v<w;v++){let B=Array.isArray(A[v])?A[v]:[A[v]];for(let L=0,D=B.length;L<D;L++){let k=B[L],H=Array.isArray(k.value)?k.value:[k.value],I=Array.isArray(A[v])||Array.isArray(k.value),q=S;for(let G=0,ne=H.length;G<ne;G++){let X=H[G],j=x(X,I),ee=S%C,Me=ee%j.boundary,Ue=ee+Me;S+=Me,Ue!==0&&C-Ue<j.storage&&(S+=C-Ue),G===0&&(q=S),S+=j.storage}let K=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new K((S-q)/Float32Array.BYTES_PER_ELEMENT),k.__offset=q}}let E=S%C;return E>0&&(S+=C-E),M.__size=S,M.__cache={},this}function x(M,A){let S={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(S.boundary=4,S.storage=4):M.isVector2?(S.boundary=8,S.storage=8):M.isVector3||M.isColor?(S.boundary=16,S.storage=12):M.isVector4?(S.boundary=16,S.storage=16):M.isMatrix3?(S.boundary=16,S.storage=48):M.isMatrix4?(S.boundary=16,S.storage=64):M.isTexture?Ie("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(M)?(S.boundary=16,S.storage=M.byteLength):Ie("WebGLRenderer: Unsupported uniform value type.",M),A===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function p(M){let A=M.target;A.removeEventListener("dispose",p),n.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function f(){for(let M in s)n.deleteBuffer(s[M]);s={},r={}}return{bind:a,update:o,dispose:f}}var Ob=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ai=null;function Bb(){return ai===null&&(ai=new $i(Ob,16,16,ri,qn),ai.name="DFG_LUT",ai.minFilter=mt,ai.magFilter=mt,ai.wrapS=Pn,ai.wrapT=Pn,ai.generateMipmaps=!1,ai.needsUpdate=!0),ai}var rc=class{constructor(e={}){let{canvas:t=lp(),context:i=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:m=!1,reversedDepthBuffer:d=!1,outputBufferType:h=jt}=e;this.isWebGLRenderer=!0;let _;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");_=i.getContextAttributes().alpha}else _=a;let x=h,p=new Set([Tl,wl,Sl]),f=new Set([jt,Xn,pr,As,bl,Ml]),M=new Uint32Array(4),A=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},C=null,E=null,v=[],w=[],B=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=si,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,D=!1,k=null,H=null,I=null,q=null;this._outputColorSpace=bn;let K=0,G=0,ne=null,X=-1,j=null,ee=new xt,Me=new xt,Ue=null,Z=new Ke(0),me=0,xe=t.width,Ee=t.height,ge=1,Oe=null,Mt=null,Re=new xt(0,0,xe,Ee),nt=new xt(0,0,xe,Ee),at=!1,Ge=new Ms,Ht=new il,Ct=!1,ln=!1,gt=new lt,$n=new V,Ft=new xt,wn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Tn=!1;function An(){return ne===null?ge:1}let N=i;function En(b,P){return t.getContext(b,P)}let ht,dt,de,Rt,Ce,De,T,y,F,te,Q,re,ue,$,Y,oe,R,J,W,le,se,ae,we;try{let b={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:m};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ae,!1),t.addEventListener("webglcontextrestored",Be,!1),t.addEventListener("webglcontextcreationerror",fe,!1),N===null){let P="webgl2";if(N=En(P,b),N===null)throw En(P)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ze()}catch(b){throw t.removeEventListener("webglcontextlost",Ae,!1),t.removeEventListener("webglcontextrestored",Be,!1),t.removeEventListener("webglcontextcreationerror",fe,!1),Le("WebGLRenderer: "+b.message),b}function ze(){ht=new Zx(N),ht.init(),se=new Ib(N,ht),dt=new Bx(N,ht,e,se),de=new Rb(N,ht),dt.reversedDepthBuffer&&d&&de.buffers.depth.setReversed(!0),H=N.createFramebuffer(),I=N.createFramebuffer(),q=N.createFramebuffer(),Rt=new Qx(N),Ce=new mb,De=new Pb(N,ht,de,Ce,dt,se,Rt),T=new Yx(L),y=new e_(N),ae=new Fx(N,y),F=new Jx(N,y,Rt,ae),te=new ey(N,F,y,ae,Rt),J=new jx(N,dt,De),Y=new kx(Ce),Q=new pb(L,T,ht,dt,ae,Y),re=new Ub(L,Ce),ue=new _b,$=new Sb(ht),R=new Ux(L,T,de,te,_,l),oe=new Cb(L,te,dt),we=new Fb(N,Rt,dt,de),W=new Ox(N,ht,Rt),le=new Kx(N,ht,Rt),Rt.programs=Q.programs,L.capabilities=dt,L.extensions=ht,L.properties=Ce,L.renderLists=ue,L.shadowMap=oe,L.state=de,L.info=Rt}x!==jt&&(B=new ny(x,t.width,t.height,o,s,r));let ie=new mh(L,N);this.xr=ie,this.getContext=function(){return N},this.getContextAttributes=function(){return N.getContextAttributes()},this.forceContextLoss=function(){let b=ht.get("WEBGL_lose_context");b&&b.loseContext()},this.forceContextRestore=function(){let b=ht.get("WEBGL_lose_context");b&&b.restoreContext()},this.getPixelRatio=function(){return ge},this.setPixelRatio=function(b){b!==void 0&&(ge=b,this.setSize(xe,Ee,!1))},this.getSize=function(b){return b.set(xe,Ee)},this.setSize=function(b,P,z=!0){if(ie.isPresenting){Ie("WebGLRenderer: Can't change size while VR device is presenting.");return}xe=b,Ee=P,t.width=Math.floor(b*ge),t.height=Math.floor(P*ge),z===!0&&(t.style.width=b+"px",t.style.height=P+"px"),B!==null&&B.setSize(t.width,t.height),this.setViewport(0,0,b,P)},this.getDrawingBufferSize=function(b){return b.set(xe*ge,Ee*ge).floor()},this.setDrawingBufferSize=function(b,P,z){xe=b,Ee=P,ge=z,t.width=Math.floor(b*z),t.height=Math.floor(P*z),this.setViewport(0,0,b,P)},this.setEffects=function(b){if(x===jt){Le("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(b){for(let P=0;P<b.length;P++)if(b[P].isOutputPass===!0){Ie("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(b||[])},this.getCurrentViewport=function(b){return b.copy(ee)},this.getViewport=function(b){return b.copy(Re)},this.setViewport=function(b,P,z,U){b.isVector4?Re.set(b.x,b.y,b.z,b.w):Re.set(b,P,z,U),de.viewport(ee.copy(Re).multiplyScalar(An()).round())},this.getScissor=function(b){return b.copy(nt)},this.setScissor=function(b,P,z,U){b.isVector4?nt.set(b.x,b.y,b.z,b.w):nt.set(b,P,z,U),de.scissor(Me.copy(nt).multiplyScalar(An()).round())},this.getScissorTest=function(){return at},this.setScissorTest=function(b){de.setScissorTest(at=b)},this.setOpaqueSort=function(b){Oe=b},this.setTransparentSort=function(b){Mt=b},this.getClearColor=function(b){return b.copy(R.getClearColor())},this.setClearColor=function(){R.setClearColor(...arguments)},this.getClearAlpha=function(){return R.getClearAlpha()},this.setClearAlpha=function(){R.setClearAlpha(...arguments)},this.clear=function(b=!0,P=!0,z=!0){let U=0;if(b){let O=!1;if(ne!==null){let he=ne.texture.format;O=p.has(he)}if(O){let he=ne.texture.type,ve=f.has(he),ce=R.getClearColor(),_e=R.getClearAlpha(),Se=ce.r,Fe=ce.g,He=ce.b;ve?(M[0]=Se,M[1]=Fe,M[2]=He,M[3]=_e,N.clearBufferuiv(N.COLOR,0,M)):(A[0]=Se,A[1]=Fe,A[2]=He,A[3]=_e,N.clearBufferiv(N.COLOR,0,A))}else U|=N.COLOR_BUFFER_BIT}P&&(U|=N.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),z&&(U|=N.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),U!==0&&N.clear(U)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(b){b.setRenderer(this),k=b},this.dispose=function(){t.removeEventListener("webglcontextlost",Ae,!1),t.removeEventListener("webglcontextrestored",Be,!1),t.removeEventListener("webglcontextcreationerror",fe,!1),R.dispose(),ue.dispose(),$.dispose(),De.dispose(),Ce.dispose(),T.dispose(),te.dispose(),F.dispose(),ae.dispose(),we.dispose(),Q.dispose(),ie.dispose(),ie.removeEventListener("sessionstart",Sh),ie.removeEventListener("sessionend",wh),es.stop()};function Ae(b){b.preventDefault(),eh("WebGLRenderer: Context Lost."),D=!0}function Be(){eh("WebGLRenderer: Context Restored."),D=!1;let b=Rt.autoReset,P=oe.enabled,z=oe.autoUpdate,U=oe.needsUpdate,O=oe.type;ze(),Rt.autoReset=b,oe.enabled=P,oe.autoUpdate=z,oe.needsUpdate=U,oe.type=O}function fe(b){Le("WebGLRenderer: A WebGL context could not be created. Reason: ",b.statusMessage)}function it(b){let P=b.target;P.removeEventListener("dispose",it),Ot(P)}function Ot(b){Ii(b),Ce.remove(b)}function Ii(b){let P=Ce.get(b).programs;P!==void 0&&(P.forEach(function(z){Q.releaseProgram(z)}),b.isShaderMaterial&&Q.releaseShaderCache(b))}this.renderBufferDirect=function(b,P,z,U,O,he){P===null&&(P=wn);let ve=O.isMesh&&O.matrixWorld.determinantAffine()<0,ce=Tm(b,P,z,U,O);de.setMaterial(U,ve);let _e=z.index,Se=1;if(U.wireframe===!0){if(_e=F.getWireframeAttribute(z),_e===void 0)return;Se=2}let Fe=z.drawRange,He=z.attributes.position,ye=Fe.start*Se,We=(Fe.start+Fe.count)*Se;he!==null&&(ye=Math.max(ye,he.start*Se),We=Math.min(We,(he.start+he.count)*Se)),_e!==null?(ye=Math.max(ye,0),We=Math.min(We,_e.count)):He!=null&&(ye=Math.max(ye,0),We=Math.min(We,He.count));let St=We-ye;if(St<0||St===1/0)return;ae.setup(O,U,ce,z,_e);let ct,ot=W;if(_e!==null&&(ct=y.get(_e),ot=le,ot.setIndex(ct)),O.isMesh)U.wireframe===!0?(de.setLineWidth(U.wireframeLinewidth*An()),ot.setMode(N.LINES)):ot.setMode(N.TRIANGLES);else if(O.isLine){let $t=U.linewidth;$t===void 0&&($t=1),de.setLineWidth($t*An()),O.isLineSegments?ot.setMode(N.LINES):O.isLineLoop?ot.setMode(N.LINE_LOOP):ot.setMode(N.LINE_STRIP)}else O.isPoints?ot.setMode(N.POINTS):O.isSprite&&ot.setMode(N.TRIANGLES);if(O.isBatchedMesh)if(ht.get("WEBGL_multi_draw"))ot.renderMultiDraw(O._multiDrawStarts,O._multiDrawCounts,O._multiDrawCount);else{let $t=O._multiDrawStarts,be=O._multiDrawCounts,tn=O._multiDrawCount,et=_e?y.get(_e).bytesPerElement:1,ts=Ce.get(U).currentProgram.getUniforms();for(let Yt=0;Yt<tn;Yt++)ts.setValue(N,"_gl_DrawID",Yt),ot.render($t[Yt]/et,be[Yt])}else if(O.isInstancedMesh)ot.renderInstances(ye,St,O.count);else if(z.isInstancedBufferGeometry){let $t=z._maxInstanceCount!==void 0?z._maxInstanceCount:1/0,be=Math.min(z.instanceCount,$t);ot.renderInstances(ye,St,be)}else ot.render(ye,St)};function Mh(b,P,z,U){k!==null&&b.isNodeMaterial&&k.setObject(U,b),Ct===!0&&Y.setState(b,z,!1),b.transparent===!0&&b.side===Dn&&b.forceSinglePass===!1?(b.side=on,b.needsUpdate=!0,vr(b,P,U),b.side=Qi,b.needsUpdate=!0,vr(b,P,U),b.side=Dn):vr(b,P,U)}this.compile=function(b,P,z=null){z===null&&(z=b),k!==null&&k.renderStart(b,P,z),E=$.get(z),E.init(P),w.push(E),z.traverseVisible(function(O){O.isLight&&O.layers.test(P.layers)&&(E.pushLight(O),O.castShadow&&E.pushShadow(O))}),b!==z&&b.traverseVisible(function(O){O.isLight&&O.layers.test(P.layers)&&(E.pushLight(O),O.castShadow&&E.pushShadow(O))}),E.setupLights(),k!==null&&k.updateLights(E.state.lightsArray),ln=this.localClippingEnabled,Ct=Y.init(this.clippingPlanes,ln),Ct===!0&&Y.setGlobalState(this.clippingPlanes,P),k!==null&&oe.render(E.state.shadowsArray,z,P);let U=new Set;return b.traverse(function(O){if(!(O.isMesh||O.isPoints||O.isLine||O.isSprite))return;let he=O.material;if(he)if(Array.isArray(he))for(let ve=0;ve<he.length;ve++){let ce=he[ve];Mh(ce,z,P,O),U.add(ce)}else Mh(he,z,P,O),U.add(he)}),E=w.pop(),k!==null&&k.renderEnd(),U},this.compileAsync=function(b,P,z=null){let U=this.compile(b,P,z);return new Promise(O=>{function he(){if(U.forEach(function(ve){let _e=Ce.get(ve).currentProgram;(_e===void 0||_e.isReady())&&U.delete(ve)}),U.size===0){O(b);return}setTimeout(he,10)}ht.get("KHR_parallel_shader_compile")!==null?he():setTimeout(he,10)})};let mc=null;function Sm(b){mc&&mc(b)}function Sh(){es.stop()}function wh(){es.start()}let es=new Bp;es.setAnimationLoop(Sm),typeof self<"u"&&es.setContext(self),this.setAnimationLoop=function(b){mc=b,ie.setAnimationLoop(b),b===null?es.stop():es.start()},ie.addEventListener("sessionstart",Sh),ie.addEventListener("sessionend",wh),this.render=function(b,P){if(P!==void 0&&P.isCamera!==!0){Le("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;k!==null&&k.renderStart(b,P);let z=ie.enabled===!0&&ie.isPresenting===!0,U=B!==null&&(ne===null||z)&&B.begin(L,ne);if(b.matrixWorldAutoUpdate===!0&&b.updateMatrixWorld(),P.parent===null&&P.matrixWorldAutoUpdate===!0&&P.updateMatrixWorld(),ie.enabled===!0&&ie.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(ie.cameraAutoUpdate===!0&&ie.updateCamera(P),P=ie.getCamera()),b.isScene===!0&&b.onBeforeRender(L,b,P,ne),E=$.get(b,w.length),E.init(P),E.state.textureUnits=De.getTextureUnits(),w.push(E),gt.multiplyMatrices(P.projectionMatrix,P.matrixWorldInverse),P.isArrayCamera?Ht.setFromArrayCamera(P):Ge.setFromProjectionMatrix(gt,In,P.reversedDepth),ln=this.localClippingEnabled,Ct=Y.init(this.clippingPlanes,ln),C=ue.get(b,v.length),C.init(),v.push(C),this.info.render.frame++,ie.enabled===!0&&ie.isPresenting===!0){let ve=L.xr.getDepthSensingMesh();ve!==null&&gc(ve,P,-1/0,L.sortObjects)}gc(b,P,0,L.sortObjects),C.finish(),k!==null&&k.updateLights(E.state.lightsArray),L.sortObjects===!0&&C.sort(Oe,Mt),Tn=ie.enabled===!1||ie.isPresenting===!1||ie.hasDepthSensing()===!1,Tn&&R.addToRenderList(C,b),this.info.autoReset===!0&&this.info.reset(),Ct===!0&&Y.beginShadows();let O=E.state.shadowsArray;if(oe.render(O,b,P),Ct===!0&&Y.endShadows(),(U&&B.hasRenderPass())===!1){let ve=C.opaque,ce=C.transmissive;if(E.setupLights(),P.isArrayCamera){let _e=P.cameras;if(ce.length>0)for(let Se=0,Fe=_e.length;Se<Fe;Se++){let He=_e[Se];Ah(ve,ce,b,He)}Tn&&R.render(b);for(let Se=0,Fe=_e.length;Se<Fe;Se++){let He=_e[Se];Th(C,b,He,He.viewport)}}else ce.length>0&&Ah(ve,ce,b,P),Tn&&R.render(b),Th(C,b,P)}ne!==null&&G===0&&(De.updateMultisampleRenderTarget(ne),De.updateRenderTargetMipmap(ne)),U&&B.end(L),b.isScene===!0&&b.onAfterRender(L,b,P),ae.resetDefaultState(),X=-1,j=null,w.pop(),w.length>0?(E=w[w.length-1],De.setTextureUnits(E.state.textureUnits),Ct===!0&&Y.setGlobalState(L.clippingPlanes,E.state.camera)):E=null,v.pop(),v.length>0?C=v[v.length-1]:C=null,k!==null&&k.renderEnd()};function gc(b,P,z,U){if(b.visible===!1)return;if(b.layers.test(P.layers)){if(b.isGroup)z=b.renderOrder;else if(b.isLOD)b.autoUpdate===!0&&b.update(P);else if(b.isLight)E.pushLight(b),b.castShadow&&E.pushShadow(b);else if(b.isSprite){let ve=P.isArrayCamera?Ht:Ge;if(!b.frustumCulled||b.intersectsFrustum(ve)){U&&Ft.setFromMatrixPosition(b.matrixWorld).applyMatrix4(gt);let ce=te.update(b),_e=b.material;_e.visible&&C.push(b,ce,_e,z,Ft.z,null,P)}}else if(b.isMesh||b.isLine||b.isPoints){let ve=P.isArrayCamera?Ht:Ge;if(!b.frustumCulled||b.intersectsFrustum(ve)){let ce=te.update(b),_e=b.material;if(U&&(b.boundingSphere!==void 0?(b.boundingSphere===null&&b.computeBoundingSphere(),Ft.copy(b.boundingSphere.center)):(ce.boundingSphere===null&&ce.computeBoundingSphere(),Ft.copy(ce.boundingSphere.center)),Ft.applyMatrix4(b.matrixWorld).applyMatrix4(gt)),Array.isArray(_e)){let Se=ce.groups;for(let Fe=0,He=Se.length;Fe<He;Fe++){let ye=Se[Fe],We=_e[ye.materialIndex];We&&We.visible&&C.push(b,ce,We,z,Ft.z,ye,P)}}else _e.visible&&C.push(b,ce,_e,z,Ft.z,null,P)}}}let he=b.children;for(let ve=0,ce=he.length;ve<ce;ve++)gc(he[ve],P,z,U)}function Th(b,P,z,U){let{opaque:O,transmissive:he,transparent:ve}=b;E.setupLightsView(z),Ct===!0&&Y.setGlobalState(L.clippingPlanes,z),U&&de.viewport(ee.copy(U)),O.length>0&&Ra(O,P,z),he.length>0&&Ra(he,P,z),ve.length>0&&Ra(ve,P,z),de.buffers.depth.setTest(!0),de.buffers.depth.setMask(!0),de.buffers.color.setMask(!0),de.setPolygonOffset(!1)}function Ah(b,P,z,U){if((z.isScene===!0?z.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[U.id]===void 0){let ye=ht.has("EXT_color_buffer_half_float")||ht.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[U.id]=new Gt(1,1,{generateMipmaps:!0,type:ye?qn:jt,minFilter:Ai,samples:Math.max(4,dt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Xe.workingColorSpace})}let he=E.state.transmissionRenderTarget[U.id],ve=U.viewport||ee;he.setSize(ve.z*L.transmissionResolutionScale,ve.w*L.transmissionResolutionScale);let ce=L.getRenderTarget(),_e=L.getActiveCubeFace(),Se=L.getActiveMipmapLevel();L.setRenderTarget(he),L.getClearColor(Z),me=L.getClearAlpha(),me<1&&L.setClearColor(16777215,.5),L.clear(),Tn&&R.render(z);let Fe=L.toneMapping;L.toneMapping=si;let He=U.viewport;if(U.viewport!==void 0&&(U.viewport=void 0),E.setupLightsView(U),Ct===!0&&Y.setGlobalState(L.clippingPlanes,U),Ra(b,z,U),De.updateMultisampleRenderTarget(he),De.updateRenderTargetMipmap(he),ht.has("WEBGL_multisampled_render_to_texture")===!1){let ye=!1;for(let We=0,St=P.length;We<St;We++){let ct=P[We],{object:ot,geometry:$t,material:be,group:tn}=ct;if(be.side===Dn&&ot.layers.test(U.layers)){let et=be.side;be.side=on,be.needsUpdate=!0,Eh(ot,z,U,$t,be,tn),be.side=et,be.needsUpdate=!0,ye=!0}}ye===!0&&(De.updateMultisampleRenderTarget(he),De.updateRenderTargetMipmap(he))}L.setRenderTarget(ce,_e,Se),L.setClearColor(Z,me),He!==void 0&&(U.viewport=He),L.toneMapping=Fe}function Ra(b,P,z){let U=P.isScene===!0?P.overrideMaterial:null;for(let O=0,he=b.length;O<he;O++){let ve=b[O],{object:ce,geometry:_e,group:Se}=ve,Fe=ve.material;Fe.allowOverride===!0&&U!==null&&(Fe=U),ce.layers.test(z.layers)&&Eh(ce,P,z,_e,Fe,Se)}}function Eh(b,P,z,U,O,he){k!==null&&O.isNodeMaterial&&k.setObject(b,O),b.onBeforeRender(L,P,z,U,O,he),b.modelViewMatrix.multiplyMatrices(z.matrixWorldInverse,b.matrixWorld),b.normalMatrix.getNormalMatrix(b.modelViewMatrix),O.onBeforeRender(L,P,z,U,b,he),O.transparent===!0&&O.side===Dn&&O.forceSinglePass===!1?(O.side=on,O.needsUpdate=!0,L.renderBufferDirect(z,P,U,O,b,he),O.side=Qi,O.needsUpdate=!0,L.renderBufferDirect(z,P,U,O,b,he),O.side=Dn):L.renderBufferDirect(z,P,U,O,b,he),b.onAfterRender(L,P,z,U,O,he)}function Ch(b){let P=0;for(let z of b)z.texture!==null&&P++;return P}function vr(b,P,z){P.isScene!==!0&&(P=wn);let U=Ce.get(b),O=E.state.lights,he=E.state.shadowsArray,ve=O.state.version,ce=Q.getParameters(b,O.state,he,P,z,E.state.lightProbeGridArray),_e=Q.getProgramCacheKey(ce),Se=U.programs;U.environment=b.isMeshStandardMaterial||b.isMeshLambertMaterial||b.isMeshPhongMaterial?P.environment:null,U.fog=P.fog;let Fe=b.isMeshStandardMaterial||b.isMeshLambertMaterial&&!b.envMap||b.isMeshPhongMaterial&&!b.envMap;U.envMap=T.get(b.envMap||U.environment,Fe),U.envMapRotation=U.environment!==null&&b.envMap===null?P.environmentRotation:b.envMapRotation,Se===void 0&&(b.addEventListener("dispose",it),Se=new Map,U.programs=Se,U.programVariants=new Map);let He=Se.get(_e);if(He!==void 0){if(U.currentProgram===He&&U.lightsStateVersion===ve)return Ph(b,ce),He}else ce.uniforms=Q.getUniforms(b),k!==null&&b.isNodeMaterial&&k.build(b,z,ce),b.onBeforeCompile(ce,L),He=Q.acquireProgram(ce,_e),Se.set(_e,He),U.uniforms=ce.uniforms;let ye=U.uniforms;return(!b.isShaderMaterial&&!b.isRawShaderMaterial||b.clipping===!0)&&(ye.clippingPlanes=Y.uniform),Ph(b,ce),U.needsLights=Em(b),U.lightsStateVersion=ve,U.needsLights&&(ye.ambientLightColor.value=O.state.ambient,ye.lightProbe.value=O.state.probe,ye.sunLights.value=O.state.sun,ye.sunLightShadows.value=O.state.sunShadow,ye.directionalLights.value=O.state.directional,ye.directionalLightShadows.value=O.state.directionalShadow,ye.spotLights.value=O.state.spot,ye.spotLightShadows.value=O.state.spotShadow,ye.rectAreaLights.value=O.state.rectArea,ye.ltc_1.value=O.state.rectAreaLTC1,ye.ltc_2.value=O.state.rectAreaLTC2,ye.pointLights.value=O.state.point,ye.pointLightShadows.value=O.state.pointShadow,ye.hemisphereLights.value=O.state.hemi,ye.sunShadowMatrix.value=O.state.sunShadowMatrix,ye.sunShadowCascade.value=O.state.sunShadowCascade,ye.directionalShadowMatrix.value=O.state.directionalShadowMatrix,ye.spotLightMatrix.value=O.state.spotLightMatrix,ye.spotLightMap.value=O.state.spotLightMap,ye.pointShadowMatrix.value=O.state.pointShadowMatrix),U.numLightProbeGrids=Ch(E.state.lightProbeGridArray),U.currentProgram=He,U.uniformsList=null,He}function wm(b,P,z,U,O){let he=Ce.get(b),ve=he.currentProgram.id+","+U+","+O,ce=he.programVariants.get(ve);return ce===void 0?(ce=vr(b,P,z),he.programVariants.set(ve,ce)):(he.currentProgram=ce,he.uniformsList=null,he.outputColorSpace=U,he.toneMapping=O),ce}function Rh(b){if(b.uniformsList===null){let P=b.currentProgram.getUniforms();b.uniformsList=mr.seqWithValue(P.seq,b.uniforms)}return b.uniformsList}function Ph(b,P){let z=Ce.get(b);z.outputColorSpace=P.outputColorSpace,z.batching=P.batching,z.batchingColor=P.batchingColor,z.instancing=P.instancing,z.instancingColor=P.instancingColor,z.instancingMorph=P.instancingMorph,z.skinning=P.skinning,z.morphTargets=P.morphTargets,z.morphNormals=P.morphNormals,z.morphColors=P.morphColors,z.morphTargetsCount=P.morphTargetsCount,z.numClippingPlanes=P.numClippingPlanes,z.numIntersection=P.numClipIntersection,z.vertexAlphas=P.vertexAlphas,z.vertexTangents=P.vertexTangents,z.toneMapping=P.toneMapping}function Tm(b,P,z,U,O){P.isScene!==!0&&(P=wn),De.resetTextureUnits();let he=P.fog,ve=U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial?P.environment:null,ce=ne===null?L.outputColorSpace:ne.isXRRenderTarget===!0?ne.texture.colorSpace:Xe.workingColorSpace,_e=U.isMeshStandardMaterial||U.isMeshLambertMaterial&&!U.envMap||U.isMeshPhongMaterial&&!U.envMap,Se=T.get(U.envMap||ve,_e),Fe=U.vertexColors===!0&&!!z.attributes.color&&z.attributes.color.itemSize===4,He=!!z.attributes.tangent&&(!!U.normalMap||U.anisotropy>0),ye=!!z.morphAttributes.position,We=!!z.morphAttributes.normal,St=!!z.morphAttributes.color,ct=si;U.toneMapped&&(ne===null||ne.isXRRenderTarget===!0)&&(ct=L.toneMapping);let ot=z.morphAttributes.position||z.morphAttributes.normal||z.morphAttributes.color,$t=ot!==void 0?ot.length:0,be=Ce.get(U),tn=E.state.lights;if(Ct===!0&&(ln===!0||b!==j)){let _t=b===j&&U.id===X;Y.setState(U,b,_t)}let et=!1,ts=!1;U.version===be.__version?be.needsLights&&be.lightsStateVersion!==tn.state.version||O.isBatchedMesh&&be.batching===!1||!O.isBatchedMesh&&be.batching===!0||O.isBatchedMesh&&be.batchingColor===!0&&O._colorsTexture===null||O.isBatchedMesh&&be.batchingColor===!1&&O._colorsTexture!==null||O.isInstancedMesh&&be.instancing===!1||!O.isInstancedMesh&&be.instancing===!0||O.isSkinnedMesh&&be.skinning===!1||!O.isSkinnedMesh&&be.skinning===!0||O.isInstancedMesh&&be.instancingColor===!0&&O.instanceColor===null||O.isInstancedMesh&&be.instancingColor===!1&&O.instanceColor!==null||O.isInstancedMesh&&be.instancingMorph===!0&&O.morphTexture===null||O.isInstancedMesh&&be.instancingMorph===!1&&O.morphTexture!==null||be.envMap!==Se||U.fog===!0&&be.fog!==he||be.numClippingPlanes!==void 0&&(be.numClippingPlanes!==Y.numPlanes||be.numIntersection!==Y.numIntersection)||be.vertexAlphas!==Fe||be.vertexTangents!==He||be.morphTargets!==ye||be.morphNormals!==We||be.morphColors!==St||be.morphTargetsCount!==$t||be.numLightProbeGrids!==Ch(E.state.lightProbeGridArray)?et=!0:(be.outputColorSpace!==ce||be.toneMapping!==ct)&&(ts=!0):(et=!0,be.__version=U.version);let Yt=be.currentProgram;(et===!0||ts===!0)&&(Yt=ts===!0?wm(U,P,O,ce,ct):vr(U,P,O),k&&U.isNodeMaterial&&k.onUpdateProgram(U,Yt,be));let Pa=!1,Li=!1,ns=!1,Ze=Yt.getUniforms(),Wt=be.uniforms;if(de.useProgram(Yt.program)&&(Pa=!0,Li=!0,ns=!0),U.id!==X&&(X=U.id,Li=!0),Pa||j!==b){de.buffers.depth.getReversed()&&b.reversedDepth!==!0&&(b._reversedDepth=!0,b.updateProjectionMatrix()),Ze.setValue(N,"projectionMatrix",b.projectionMatrix),Ze.setValue(N,"viewMatrix",b.matrixWorldInverse);let Bt=Ze.map.cameraPosition;Bt!==void 0&&Bt.setValue(N,$n.setFromMatrixPosition(b.matrixWorld)),dt.logarithmicDepthBuffer&&Ze.setValue(N,"logDepthBufFC",2/(Math.log(b.far+1)/Math.LN2)),(U.isMeshPhongMaterial||U.isMeshToonMaterial||U.isMeshLambertMaterial||U.isMeshBasicMaterial||U.isMeshStandardMaterial||U.isShaderMaterial)&&Ze.setValue(N,"isOrthographic",b.isOrthographicCamera===!0),j!==b&&(j=b,Li=!0,ns=!0)}if(be.needsLights&&(tn.state.sunShadowMap.length>0&&Ze.setValue(N,"sunShadowMap",tn.state.sunShadowMap,De),tn.state.directionalShadowMap.length>0&&Ze.setValue(N,"directionalShadowMap",tn.state.directionalShadowMap,De),tn.state.spotShadowMap.length>0&&Ze.setValue(N,"spotShadowMap",tn.state.spotShadowMap,De),tn.state.pointShadowMap.length>0&&Ze.setValue(N,"pointShadowMap",tn.state.pointShadowMap,De)),O.isSkinnedMesh){Ze.setOptional(N,O,"bindMatrix"),Ze.setOptional(N,O,"bindMatrixInverse");let _t=O.skeleton;_t&&(_t.boneTexture===null&&_t.computeBoneTexture(),Ze.setValue(N,"boneTexture",_t.boneTexture,De))}O.isBatchedMesh&&(Ze.setOptional(N,O,"batchingTexture"),Ze.setValue(N,"batchingTexture",O._matricesTexture,De),Ze.setOptional(N,O,"batchingIdTexture"),Ze.setValue(N,"batchingIdTexture",O._indirectTexture,De),Ze.setOptional(N,O,"batchingColorTexture"),O._colorsTexture!==null&&Ze.setValue(N,"batchingColorTexture",O._colorsTexture,De));let Un=z.morphAttributes;if((Un.position!==void 0||Un.normal!==void 0||Un.color!==void 0)&&J.update(O,z,Yt),(Li||be.receiveShadow!==O.receiveShadow)&&(be.receiveShadow=O.receiveShadow,Ze.setValue(N,"receiveShadow",O.receiveShadow)),(U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial)&&U.envMap===null&&P.environment!==null&&(Wt.envMapIntensity.value=P.environmentIntensity),Wt.dfgLUT!==void 0&&(Wt.dfgLUT.value=Bb()),Li){if(Ze.setValue(N,"toneMappingExposure",L.toneMappingExposure),be.needsLights&&Am(Wt,ns),he&&U.fog===!0&&re.refreshFogUniforms(Wt,he),re.refreshMaterialUniforms(Wt,U,ge,Ee,E.state.transmissionRenderTarget[b.id]),be.needsLights&&be.numLightProbeGrids>0){let _t=S,Bt=0;for(let ci of E.state.lightProbeGridArray)ci.texture!==null&&(_t.textures[Bt]=ci.texture,_t.min[Bt]=ci.boundingBox.min,_t.max[Bt]=ci.boundingBox.max,_t.resolution[Bt]=ci.resolution,Bt++);for(let ci in _t)_t[ci].length=Bt;Wt.probesSH.value=_t.textures,Wt.probesMin.value=_t.min,Wt.probesMax.value=_t.max,Wt.probesResolution.value=_t.resolution}mr.upload(N,Rh(be),Wt,De)}if(U.isShaderMaterial&&U.uniformsNeedUpdate===!0&&(mr.upload(N,Rh(be),Wt,De),U.uniformsNeedUpdate=!1),U.isSpriteMaterial&&Ze.setValue(N,"center",O.center),Ze.setValue(N,"modelViewMatrix",O.modelViewMatrix),Ze.setValue(N,"normalMatrix",O.normalMatrix),Ze.setValue(N,"modelMatrix",O.matrixWorld),U.uniformsGroups!==void 0){let _t=U.uniformsGroups;for(let Bt=0,ci=_t.length;Bt<ci;Bt++){let Lh=_t[Bt];we.update(Lh,Yt),we.bind(Lh,Yt)}}return Yt}function Am(b,P){b.ambientLightColor.needsUpdate=P,b.lightProbe.needsUpdate=P,b.sunLights.needsUpdate=P,b.sunLightShadows.needsUpdate=P,b.directionalLights.needsUpdate=P,b.directionalLightShadows.needsUpdate=P,b.pointLights.needsUpdate=P,b.pointLightShadows.needsUpdate=P,b.spotLights.needsUpdate=P,b.spotLightShadows.needsUpdate=P,b.rectAreaLights.needsUpdate=P,b.hemisphereLights.needsUpdate=P}function Em(b){return b.isMeshLambertMaterial||b.isMeshToonMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isShadowMaterial||b.isShaderMaterial&&b.lights===!0}this.getActiveCubeFace=function(){return K},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return ne},this.setRenderTargetTextures=function(b,P,z){let U=Ce.get(b);U.__autoAllocateDepthBuffer=b.resolveDepthBuffer===!1,U.__autoAllocateDepthBuffer===!1&&(U.__useRenderToTexture=!1),Ce.get(b.texture).__webglTexture=P,Ce.get(b.depthTexture).__webglTexture=U.__autoAllocateDepthBuffer?void 0:z,U.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(b,P){let z=Ce.get(b);z.__webglFramebuffer=P,z.__useDefaultFramebuffer=P===void 0},this.setRenderTarget=function(b,P=0,z=0){ne=b,K=P,G=z;let U=null,O=!1,he=!1;if(b){let ce=Ce.get(b);if(ce.__useDefaultFramebuffer!==void 0){de.bindFramebuffer(N.FRAMEBUFFER,ce.__webglFramebuffer),ee.copy(b.viewport),Me.copy(b.scissor),Ue=b.scissorTest,de.viewport(ee),de.scissor(Me),de.setScissorTest(Ue),X=-1;return}else if(ce.__webglFramebuffer===void 0)De.setupRenderTarget(b);else if(ce.__hasExternalTextures)De.rebindTextures(b,Ce.get(b.texture).__webglTexture,Ce.get(b.depthTexture).__webglTexture);else if(b.depthBuffer){let Fe=b.depthTexture;if(ce.__boundDepthTexture!==Fe){if(Fe!==null&&Ce.has(Fe)&&(b.width!==Fe.image.width||b.height!==Fe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");De.setupDepthRenderbuffer(b)}}let _e=b.texture;(_e.isData3DTexture||_e.isDataArrayTexture||_e.isCompressedArrayTexture)&&(he=!0);let Se=Ce.get(b).__webglFramebuffer;b.isWebGLCubeRenderTarget?(Array.isArray(Se[P])?U=Se[P][z]:U=Se[P],O=!0):b.samples>0&&De.useMultisampledRTT(b)===!1?U=Ce.get(b).__webglMultisampledFramebuffer:Array.isArray(Se)?U=Se[z]:U=Se,ee.copy(b.viewport),Me.copy(b.scissor),Ue=b.scissorTest}else ee.copy(Re).multiplyScalar(ge).floor(),Me.copy(nt).multiplyScalar(ge).floor(),Ue=at;if(z!==0&&(U=H),de.bindFramebuffer(N.FRAMEBUFFER,U)&&de.drawBuffers(b,U),de.viewport(ee),de.scissor(Me),de.setScissorTest(Ue),O){let ce=Ce.get(b.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_CUBE_MAP_POSITIVE_X+P,ce.__webglTexture,z)}else if(he){let ce=P;for(let _e=0;_e<b.textures.length;_e++){let Se=Ce.get(b.textures[_e]);N.framebufferTextureLayer(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0+_e,Se.__webglTexture,z,ce)}}else if(b!==null&&z!==0){let ce=Ce.get(b.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,ce.__webglTexture,z)}X=-1};function Ih(b){let P=Ce.get(b);return(P.__readFormat!==b.format||P.__readType!==b.type)&&(P.__readFormat=b.format,P.__readType=b.type,P.__formatReadable=dt.textureFormatReadable(b.format),P.__typeReadable=dt.textureTypeReadable(b.type)),P}this.readRenderTargetPixels=function(b,P,z,U,O,he,ve,ce=0){if(!(b&&b.isWebGLRenderTarget)){Le("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let _e=Ce.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&ve!==void 0&&(_e=_e[ve],Array.isArray(_e)&&(_e=_e[0])),_e){de.bindFramebuffer(N.FRAMEBUFFER,_e);try{let Se=b.textures[ce],Fe=Se.format,He=Se.type;b.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+ce);let ye=Ih(Se);if(ye.__formatReadable===!1){Le("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ye.__typeReadable===!1){Le("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}P>=0&&P<=b.width-U&&z>=0&&z<=b.height-O&&N.readPixels(P,z,U,O,se.convert(Fe),se.convert(He),he)}finally{let Se=ne!==null?Ce.get(ne).__webglFramebuffer:null;de.bindFramebuffer(N.FRAMEBUFFER,Se)}}},this.readRenderTargetPixelsAsync=async function(b,P,z,U,O,he,ve,ce=0){if(!(b&&b.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let _e=Ce.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&ve!==void 0&&(_e=_e[ve],Array.isArray(_e)&&(_e=_e[0])),_e)if(P>=0&&P<=b.width-U&&z>=0&&z<=b.height-O){de.bindFramebuffer(N.FRAMEBUFFER,_e);let Se=b.textures[ce],Fe=Se.format,He=Se.type;b.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+ce);let ye=Ih(Se);if(ye.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ye.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let We=N.createBuffer();N.bindBuffer(N.PIXEL_PACK_BUFFER,We),N.bufferData(N.PIXEL_PACK_BUFFER,he.byteLength,N.STREAM_READ),N.readPixels(P,z,U,O,se.convert(Fe),se.convert(He),0),N.bindBuffer(N.PIXEL_PACK_BUFFER,null);let St=ne!==null?Ce.get(ne).__webglFramebuffer:null;de.bindFramebuffer(N.FRAMEBUFFER,St);let ct=N.fenceSync(N.SYNC_GPU_COMMANDS_COMPLETE,0);return N.flush(),await up(N,ct,4),N.bindBuffer(N.PIXEL_PACK_BUFFER,We),N.getBufferSubData(N.PIXEL_PACK_BUFFER,0,he),N.bindBuffer(N.PIXEL_PACK_BUFFER,null),N.deleteBuffer(We),N.deleteSync(ct),he}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(b,P=null,z=0){let U=Math.pow(2,-z),O=Math.floor(b.image.width*U),he=Math.floor(b.image.height*U),ve=P!==null?P.x:0,ce=P!==null?P.y:0;De.setTexture2D(b,0),N.copyTexSubImage2D(N.TEXTURE_2D,z,0,0,ve,ce,O,he),de.unbindTexture()},this.copyTextureToTexture=function(b,P,z=null,U=null,O=0,he=0){let ve,ce,_e,Se,Fe,He,ye,We,St,ct=b.isCompressedTexture?b.mipmaps[he]:b.image;if(z!==null)ve=z.max.x-z.min.x,ce=z.max.y-z.min.y,_e=z.isBox3?z.max.z-z.min.z:1,Se=z.min.x,Fe=z.min.y,He=z.isBox3?z.min.z:0;else{let Ze=Math.pow(2,-O);ve=Math.floor(ct.width*Ze),ce=Math.floor(ct.height*Ze),b.isDataArrayTexture?_e=ct.depth:b.isData3DTexture?_e=Math.floor(ct.depth*Ze):_e=1,Se=0,Fe=0,He=0}U!==null?(ye=U.x,We=U.y,St=U.z):(ye=0,We=0,St=0);let ot=se.convert(P.format),$t=se.convert(P.type),be;P.isData3DTexture?(De.setTexture3D(P,0),be=N.TEXTURE_3D):P.isDataArrayTexture||P.isCompressedArrayTexture?(De.setTexture2DArray(P,0),be=N.TEXTURE_2D_ARRAY):(De.setTexture2D(P,0),be=N.TEXTURE_2D),de.activeTexture(N.TEXTURE0),de.pixelStorei(N.UNPACK_FLIP_Y_WEBGL,P.flipY),de.pixelStorei(N.UNPACK_PREMULTIPLY_ALPHA_WEBGL,P.premultiplyAlpha),de.pixelStorei(N.UNPACK_ALIGNMENT,P.unpackAlignment);let tn=de.getParameter(N.UNPACK_ROW_LENGTH),et=de.getParameter(N.UNPACK_IMAGE_HEIGHT),ts=de.getParameter(N.UNPACK_SKIP_PIXELS),Yt=de.getParameter(N.UNPACK_SKIP_ROWS),Pa=de.getParameter(N.UNPACK_SKIP_IMAGES);de.pixelStorei(N.UNPACK_ROW_LENGTH,ct.width),de.pixelStorei(N.UNPACK_IMAGE_HEIGHT,ct.height),de.pixelStorei(N.UNPACK_SKIP_PIXELS,Se),de.pixelStorei(N.UNPACK_SKIP_ROWS,Fe),de.pixelStorei(N.UNPACK_SKIP_IMAGES,He);let Li=b.isDataArrayTexture||b.isData3DTexture,ns=P.isDataArrayTexture||P.isData3DTexture;if(b.isDepthTexture){let Ze=Ce.get(b),Wt=Ce.get(P),Un=Ce.get(Ze.__renderTarget),_t=Ce.get(Wt.__renderTarget);de.bindFramebuffer(N.READ_FRAMEBUFFER,Un.__webglFramebuffer),de.bindFramebuffer(N.DRAW_FRAMEBUFFER,_t.__webglFramebuffer);for(let Bt=0;Bt<_e;Bt++)Li&&(N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Ce.get(b).__webglTexture,O,He+Bt),N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Ce.get(P).__webglTexture,he,St+Bt)),N.blitFramebuffer(Se,Fe,Se+ve,Fe+ce,ye,We,ye+ve,We+ce,N.DEPTH_BUFFER_BIT,N.NEAREST);de.bindFramebuffer(N.READ_FRAMEBUFFER,null),de.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else if(O!==0||b.isRenderTargetTexture||Ce.has(b)){let Ze=Ce.get(b),Wt=Ce.get(P);de.bindFramebuffer(N.READ_FRAMEBUFFER,I),de.bindFramebuffer(N.DRAW_FRAMEBUFFER,q);for(let Un=0;Un<_e;Un++)Li?N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Ze.__webglTexture,O,He+Un):N.framebufferTexture2D(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,Ze.__webglTexture,O),ns?N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Wt.__webglTexture,he,St+Un):N.framebufferTexture2D(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,Wt.__webglTexture,he),O!==0?N.blitFramebuffer(Se,Fe,Se+ve,Fe+ce,ye,We,ye+ve,We+ce,N.COLOR_BUFFER_BIT,N.NEAREST):ns?N.copyTexSubImage3D(be,he,ye,We,St+Un,Se,Fe,ve,ce):N.copyTexSubImage2D(be,he,ye,We,Se,Fe,ve,ce);de.bindFramebuffer(N.READ_FRAMEBUFFER,null),de.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else ns?b.isDataTexture||b.isData3DTexture?N.texSubImage3D(be,he,ye,We,St,ve,ce,_e,ot,$t,ct.data):P.isCompressedArrayTexture?N.compressedTexSubImage3D(be,he,ye,We,St,ve,ce,_e,ot,ct.data):N.texSubImage3D(be,he,ye,We,St,ve,ce,_e,ot,$t,ct):b.isDataTexture?N.texSubImage2D(N.TEXTURE_2D,he,ye,We,ve,ce,ot,$t,ct.data):b.isCompressedTexture?N.compressedTexSubImage2D(N.TEXTURE_2D,he,ye,We,ct.width,ct.height,ot,ct.data):N.texSubImage2D(N.TEXTURE_2D,he,ye,We,ve,ce,ot,$t,ct);de.pixelStorei(N.UNPACK_ROW_LENGTH,tn),de.pixelStorei(N.UNPACK_IMAGE_HEIGHT,et),de.pixelStorei(N.UNPACK_SKIP_PIXELS,ts),de.pixelStorei(N.UNPACK_SKIP_ROWS,Yt),de.pixelStorei(N.UNPACK_SKIP_IMAGES,Pa),he===0&&P.generateMipmaps===!0&&P.mipmapsAutoUpdate===!0&&N.generateMipmap(be),de.unbindTexture()},this.initRenderTarget=function(b){Ce.get(b).__webglFramebuffer===void 0&&De.setupRenderTarget(b)},this.initTexture=function(b){b.isCubeTexture?De.setTextureCube(b,0):b.isData3DTexture?De.setTexture3D(b,0):b.isDataArrayTexture||b.isCompressedArrayTexture?De.setTexture2DArray(b,0):De.setTexture2D(b,0),de.unbindTexture()},this.resetState=function(){K=0,G=0,ne=null,de.reset(),ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return In}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Xe._getDrawingBufferColorSpace(e),t.unpackColorSpace=Xe._getUnpackColorSpace()}};function Zp(n,e){let t=n.fenceSync(n.SYNC_GPU_COMMANDS_COMPLETE,0);n.flush();let i=performance.now()+5e3,s=()=>{if((t&&!n.isContextLost()&&performance.now()<i?n.clientWaitSync(t,0,0):n.ALREADY_SIGNALED)===n.TIMEOUT_EXPIRED)return void window.setTimeout(s,2);t&&n.deleteSync(t),e()};s()}var lc=null;function Jp(){if(lc!==null)return lc;let n=document.createElement("canvas").getContext("webgl2"),e=n?.getExtension("WEBGL_debug_renderer_info"),t=String(n&&e?n.getParameter(e.UNMASKED_RENDERER_WEBGL):"");return n?.getExtension("WEBGL_lose_context")?.loseContext(),lc=/swiftshader|llvmpipe|software|basic render/i.test(t),lc}function Ma(n,e){let t=n+1,i=e+1,s=new Float32Array(t*i*2);for(let a=0,o=0;a<i;a++)for(let l=0;l<t;l++)s[o++]=l/n,s[o++]=a/e;let r=new Uint32Array(n*e*6);for(let a=0,o=0;a<e;a++)for(let l=0;l<n;l++){let c=a*t+l,u=c+t,m=(a+l)%2===0?[c,u,c+1,c+1,u,u+1]:[c,u,u+1,c,u+1,c+1];for(let d of m)r[o++]=d}return _h(s,new Float32Array(t*i),r)}function gh(n,e){let t=[];for(let a=0;a<n;a++)t.push([a/n,1]);for(let a=e;a>0;a--)t.push([1,a/e]);for(let a=n;a>0;a--)t.push([a/n,0]);for(let a=0;a<=e;a++)t.push([0,a/e]);let i=new Float32Array(t.length*4),s=new Float32Array(t.length*2);t.forEach(([a,o],l)=>{i.set([a,o,a,o],4*l),s.set([0,1],2*l)});let r=new Uint32Array((t.length-1)*6);for(let a=0;a+1<t.length;a++)r.set([2*a,2*a+1,2*a+2,2*a+2,2*a+1,2*a+3],6*a);return _h(i,s,r)}function Sa(){return _h(new Float32Array([0,0,1,0,0,1,1,1]),new Float32Array(4),new Uint32Array([0,1,2,2,1,3]))}function _h(n,e,t){let i=new ti;return i.setAttribute("part",new dn(n,2)),i.setAttribute("deep",new dn(e,1)),i.setIndex(new dn(t,1)),i}var vh=`
  precision highp float;
  precision highp sampler2D;
  uniform sampler2D tGround;   // r: height, g: depth of water (negative on land)
  uniform vec2 uSize;          // metres, east and north
  uniform vec2 uNodes;         // columns, rows
  uniform float uTall;         // vertical exaggeration

  // Where a node of the raster lies in the texture: the first and last nodes are centres of texels.
  vec2 texel(vec2 part) { return (part * (uNodes - 1.0) + 0.5) / uNodes; }
  vec2 ground(vec2 part) { return texture(tGround, texel(part)).rg; }
  float surface(vec2 g) { return g.r + max(g.g, 0.0); }
`,Kp=`${vh}
  uniform mat4 uViewProjection;
  in vec2 part;                // 0 to 1 from the west, 0 to 1 from the north
  in float deep;               // 1 at the foot of a wall
  uniform float uFoot;         // height of the foot, exaggerated metres
  out vec2 vPart;
  out vec3 vPlace;
  void main() {
    vec2 g = ground(part);
    float top = surface(vec2(max(g.r, 0.0), g.g)) * uTall;
    vPart = part;
    vPlace = vec2(part.x - 0.5, 0.5 - part.y).xyx * vec3(uSize, 0.0);
    vPlace.z = mix(top, uFoot, deep);
    gl_Position = uViewProjection * vec4(vPlace, 1.0);
  }
`,Qp=`${vh}
  uniform vec3 uSun;
  uniform float uRelief;       // metres, not exaggerated
  uniform int uDirections;
  uniform int uRays;
  in vec2 vPart;
  out vec4 shade;

  float height(vec2 part) { return surface(ground(part)) * uTall; }

  void main() {
    vec2 step1 = 1.0 / max(uNodes - 1.0, vec2(1.0));
    vec2 cell = uSize * step1;
    float here = height(vPart);
    float dx = (height(vPart + vec2(step1.x, 0.0)) - height(vPart - vec2(step1.x, 0.0))) / (2.0 * cell.x);
    float dy = (height(vPart - vec2(0.0, step1.y)) - height(vPart + vec2(0.0, step1.y))) / (2.0 * cell.y);
    vec3 normal = normalize(vec3(-dx, -dy, 1.0));

    float open = 0.0;
    float reach = min(cell.x, cell.y);
    for (int k = 0; k < 24; k++) {
      if (k >= uDirections) break;
      float angle = 6.2831853 * (float(k) + 0.5) / float(uDirections);
      vec2 way = vec2(cos(angle), sin(angle));
      float steepest = 0.0;
      float far = 1.0;
      for (int i = 0; i < 6; i++) {
        vec2 part = vPart + way * reach * far / uSize * vec2(1.0, -1.0);
        if (part.x < 0.0 || part.y < 0.0 || part.x > 1.0 || part.y > 1.0) break;
        steepest = max(steepest, (height(part) - here) / (reach * far));
        far *= 1.9;
      }
      open += 1.0 / (1.0 + steepest * steepest);
    }
    open /= float(uDirections);

    float flat_ = length(uSun.xy);
    float rise = uSun.z / max(flat_, 1e-4);
    vec2 toSun = uSun.xy / max(flat_, 1e-4);
    float longest = min(uRelief * uTall / max(rise, 0.02), length(uSize));
    float horizon = -1.0;
    float rays = float(uRays);
    for (int i = 1; i <= 96; i++) {
      if (i > uRays) break;
      float t = float(i) / rays;
      float far = mix(reach * float(i), longest, t * t);
      vec2 part = vPart + toSun * far / uSize * vec2(1.0, -1.0);
      if (part.x < 0.0 || part.y < 0.0 || part.x > 1.0 || part.y > 1.0) break;
      horizon = max(horizon, (height(part) - here) / far);
    }
    float soft = 0.035 + 0.06 * rise;
    float lit = smoothstep(-soft, soft, rise - horizon);
    shade = vec4(normal.xy * 0.5 + 0.5, open, lit);
  }
`,jp=`
  in vec2 part;
  uniform vec2 uNodes;
  out vec2 vPart;
  void main() {
    // Centres of the target's texels fall on nodes.
    vPart = (part * uNodes - 0.5) / max(uNodes - 1.0, vec2(1.0));
    gl_Position = vec4(part * 2.0 - 1.0, 0.0, 1.0);
  }
`,em=`${vh}
  uniform sampler2D tShade;
  uniform sampler2D tColour;   // colours of a field; alpha: how much water runs here
  uniform sampler2D tMaterial; // colours of materials; alpha: 0 what grows there, 0.5 rock on slopes, 1 all
  uniform int uMaterial;
  uniform vec3 uSun;
  uniform vec3 uEye;
  uniform float uRelief;
  uniform float uSeaHeight;    // sea level above the lowest node; far below where there is no sea
  uniform float uSnow;         // part of the relief above which snow lies; above 1: none
  uniform int uLook;           // 0 natural, 1 field, 2 clay, 3 sand
  uniform float uWall;         // 1 for the cut sides
  uniform float uContour;      // metres between contour lines; 0: none
  uniform float uHaze;         // a metre
  uniform float uQuick;        // 1: without grain, while things move and the processor draws
  uniform float uDetail;       // 1: fine grain near the eye
  uniform vec3 uBrush;         // east, north, radius; radius 0: none
  in vec2 vPart;
  in vec3 vPlace;
  out vec4 colour;

  // Light and shadow between nodes by cubic B-splines: four linear samples, no diamonds near the eye.
  vec4 smoothShade(vec2 at) {
    vec2 p = at * uNodes - 0.5, f = fract(p), base = floor(p);
    vec2 f2 = f * f, f3 = f2 * f;
    vec2 w0 = (1.0 - 3.0 * f + 3.0 * f2 - f3) / 6.0, w1 = (4.0 - 6.0 * f2 + 3.0 * f3) / 6.0, w3 = f3 / 6.0;
    vec2 w2 = 1.0 - w0 - w1 - w3, a = w0 + w1, b = w2 + w3;
    vec2 low = (base - 0.5 + w1 / a) / uNodes, high = (base + 1.5 + w3 / b) / uNodes;
    return (texture(tShade, low) * a.x + texture(tShade, vec2(high.x, low.y)) * b.x) * a.y
      + (texture(tShade, vec2(low.x, high.y)) * a.x + texture(tShade, high) * b.x) * b.y;
  }

  float hash(vec2 p) {
    vec3 q = fract(vec3(p.xyx) * 0.1031);
    q += dot(q, q.yzx + 33.33);
    return fract((q.x + q.y) * q.z);
  }
  float noise(vec2 p) {
    vec2 i = floor(p), f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(hash(i), hash(i + vec2(1, 0)), f.x), mix(hash(i + vec2(0, 1)), hash(i + vec2(1, 1)), f.x), f.y);
  }
  float grain(vec2 p) { return 0.55 * noise(p) + 0.3 * noise(p * 2.7 + 9.1) + 0.15 * noise(p * 7.3 + 4.7); }

  vec3 film(vec3 c) {
    c *= 0.92;
    c = (c * (2.51 * c + 0.03)) / (c * (2.43 * c + 0.59) + 0.14);
    return pow(clamp(c, 0.0, 1.0), vec3(1.0 / 2.2));
  }

  vec3 natural(float height, float slope, float open, float spread, vec4 material) {
    float base = max(uSeaHeight, 0.0), relief = max(uRelief - base, 1e-3);
    float share = (height - base) / relief;
    float part = share * smoothstep(10.0, 700.0, relief);   // low land is green all over
    float mottle = spread - 0.5;
    vec3 rock = mix(vec3(0.165, 0.145, 0.125), vec3(0.285, 0.255, 0.220), spread);
    vec3 scree = vec3(0.300, 0.262, 0.212) * (0.9 + 0.25 * mottle);
    vec3 wood = mix(vec3(0.058, 0.076, 0.030), vec3(0.080, 0.094, 0.038), spread);
    vec3 grass = mix(vec3(0.098, 0.108, 0.045), vec3(0.150, 0.146, 0.072), spread);
    vec3 heath = vec3(0.225, 0.195, 0.115);
    float wide = noise(vPlace.xy / (uSize.x / 7.0));
    wide = 0.65 * wide + 0.35 * (uQuick > 0.5 ? 0.5 : noise(vPlace.yx / (uSize.x / 19.0) + 3.7));
    grass = mix(grass, heath, 0.5 * smoothstep(0.50, 0.82, wide));
    wood = mix(wood, grass, 0.6 * smoothstep(0.35, 0.65, wide));
    vec3 low = mix(wood, grass, smoothstep(-0.20, 0.30, part + 0.32 * mottle - 0.3 * (1.0 - open) + 0.06));
    low = mix(low, heath, smoothstep(0.26, 0.60, part + 0.30 * mottle));
    float bare = smoothstep(0.48, 0.82, slope + 0.25 * mottle + 0.30 * smoothstep(0.5, 0.95, part));
    vec3 c = mix(low, scree, smoothstep(0.34, 0.58, slope + 0.18 * mottle + 0.12 * part) * 0.8);
    c = mix(c, rock, bare);
    float shows = max(smoothstep(0.55, 0.95, material.a), smoothstep(0.05, 0.45, material.a) * (0.30 + 0.70 * smoothstep(0.10, 0.42, slope + 0.10 * mottle)));
    c = mix(c, material.rgb * (0.72 + 0.30 * spread), shows);
    float beach = 1.0 - smoothstep(0.006, 0.018, (height - uSeaHeight) / max(relief, 30.0) + 0.008 * mottle) * step(material.a, 0.7);
    c = mix(c, vec3(0.46, 0.40, 0.28), beach * (1.0 - smoothstep(0.2, 0.5, slope)));
    float line = share + 0.13 * mottle + 0.10 * (open - 0.85) - 0.20 * smoothstep(0.75, 1.6, slope);
    float snow = smoothstep(uSnow - 0.03, uSnow + 0.07, line) * (1.0 - 0.85 * smoothstep(0.95, 1.7, slope));
    return mix(c, vec3(0.80, 0.83, 0.88), snow);
  }

  void main() {
    vec2 g = ground(vPart);
    if (g.r < -0.5) discard;
    float depth = g.g;
    vec3 toEye = uEye - vPlace;
    float far = length(toEye);
    vec3 view = toEye / far;
    vec3 lit;
    if (uWall > 0.5) {
      float height = vPlace.z / uTall;
      vec2 face = normalize(abs(vPart - 0.5).x > abs(vPart - 0.5).y ? vec2(sign(vPart.x - 0.5), 0.0) : vec2(0.0, sign(0.5 - vPart.y)));
      float sun = max(dot(face, uSun.xy), 0.0);
      float beds = 0.5 + 0.5 * sin(height / max(uRelief, 1.0) * 46.0 + 3.0 * noise(vPart * 9.0));
      float under = (g.r - height) / max(uRelief, 1.0);
      vec3 earth = mix(vec3(0.115, 0.100, 0.088), vec3(0.085, 0.077, 0.072), smoothstep(0.2, 0.8, beds) * 0.6);
      earth = mix(vec3(0.17, 0.14, 0.11), earth, smoothstep(0.0, 0.035, under));
      lit = earth * (0.35 + 1.1 * sun) * mix(1.0, 0.35, smoothstep(0.0, 1.2, under));
      if (under < 0.0) lit = mix(vec3(0.020, 0.075, 0.105), vec3(0.05, 0.17, 0.20), exp(under * 6.0) * 0.6) * (0.6 + 0.6 * sun);
    } else {
      vec4 s = uDetail > 0.5 ? smoothShade(texel(vPart)) : texture(tShade, texel(vPart));
      vec2 flat_ = s.rg * 2.0 - 1.0;
      vec3 normal = vec3(flat_, sqrt(max(1.0 - dot(flat_, flat_), 0.02)));
      float slope = length(flat_) / normal.z / uTall;
      float open = s.b, shadow = s.a;
      vec4 field = texture(tColour, texel(vPart));
      vec4 material = uMaterial == 1 ? texture(tMaterial, texel(vPart)) : vec4(0.0);
      material.rgb = pow(material.rgb, vec3(2.2)) * 0.72;
      float metre = uSize.x / 260.0;
      float spread = uQuick > 0.5 ? 0.5 : grain(vPlace.xy / metre);
      if (uDetail > 0.5) {
        float fine = max(uSize.x / uNodes.x, 1e-3) * 0.8;
        float near = exp(-far / (fine * 260.0));
        if (near > 0.02) {
          float a = grain(vPlace.xy / fine), b = grain((vPlace.xy + vec2(fine * 0.35, 0.0)) / fine), d = grain((vPlace.xy + vec2(0.0, fine * 0.35)) / fine);
          normal = normalize(normal + vec3(a - b, a - d, 0.0) * near * (0.35 + slope));
          spread = mix(spread, a, near * 0.6);
        }
      }
      vec3 albedo = uLook == 1 ? pow(field.rgb, vec3(2.2)) * 0.62
        : uLook == 2 ? vec3(0.36, 0.335, 0.30)
        : uLook == 3 ? mix(vec3(0.46, 0.30, 0.145), vec3(0.54, 0.37, 0.195), spread) * (0.9 + 0.1 * normal.z) * (uMaterial == 1 ? mix(vec3(0.52, 0.50, 0.50), vec3(1.0), smoothstep(0.2, 0.9, material.a)) : vec3(1.0))
        : natural(g.r, slope, open, spread, material);
      if (uLook == 0) albedo = mix(albedo, vec3(0.070, 0.125, 0.150), field.a * 0.85);
      float sun = max(dot(normal, uSun), 0.0) * shadow;
      vec3 warm = mix(vec3(1.0, 0.70, 0.46), vec3(1.0, 0.955, 0.88), smoothstep(0.05, 0.6, uSun.z));
      float shut = mix(0.30, 1.0, smoothstep(0.35, 1.0, open)) * (0.55 + 0.45 * open);
      vec3 sky = vec3(0.43, 0.52, 0.66) * (0.55 + 0.45 * normal.z) * shut;
      vec3 bounce = vec3(0.24, 0.19, 0.14) * (1.0 - open) * (0.4 + sun);
      lit = albedo * (warm * sun * 2.7 + sky * 0.62 + bounce);
      if (depth > 0.0 && uLook != 1) {
        float scale = clamp(uRelief * 0.02, 1e-2, 9.0);
        float path = depth / scale;
        vec3 through = exp(-path * vec3(1.15, 0.50, 0.38));
        vec3 bed = vec3(0.42, 0.38, 0.29) * (warm * shadow * 1.6 + 0.35);
        vec3 body = mix(vec3(0.012, 0.075, 0.115), vec3(0.006, 0.032, 0.066), 1.0 - exp(-path * 0.12)) * (1.0 + 1.6 * shadow * uSun.z);
        vec3 ripple = normalize(vec3((grain(vPlace.xy / metre * 5.0) - 0.5) * 0.035, (grain(vPlace.yx / metre * 5.0 + 7.0) - 0.5) * 0.035, 1.0));
        float graze = pow(1.0 - max(dot(view, ripple), 0.0), 5.0);
        vec3 glint = warm * pow(max(dot(reflect(-uSun, ripple), view), 0.0), 220.0) * 2.2 * shadow;
        vec3 water = bed * through + body * (1.0 - through);
        water = mix(water, vec3(0.26, 0.36, 0.46), (0.03 + 0.75 * graze)) + glint;
        float shore = smoothstep(0.0, scale * 0.05, depth);
        lit = mix(lit, water, shore);
      }
      if (uContour > 0.0 && depth <= 0.0) {
        float level = g.r / uContour, wide = fwidth(level);
        float line = 1.0 - smoothstep(0.6 * wide, 1.5 * wide, abs(fract(level - 0.5) - 0.5));
        lit *= 1.0 - 0.55 * line * (1.0 - smoothstep(0.35, 0.9, wide));
      }
      if (uBrush.z > 0.0) {
        float off = abs(length(vPlace.xy - uBrush.xy) - uBrush.z);
        float wide = max(fwidth(length(vPlace.xy - uBrush.xy)) * 1.6, 1e-3);
        lit = mix(lit, vec3(1.6, 1.25, 0.5), 1.0 - smoothstep(wide * 0.5, wide, off));
        lit += vec3(0.07, 0.05, 0.01) * (1.0 - smoothstep(0.0, uBrush.z, length(vPlace.xy - uBrush.xy)));
      }
    }
    vec3 air = mix(vec3(0.135, 0.165, 0.205), vec3(0.34, 0.30, 0.25), pow(max(dot(-view, uSun), 0.0), 6.0));
    lit = mix(lit, air, 1.0 - exp(-far * uHaze));
    colour = vec4(film(lit), 1.0);
  }
`,tm=`
  precision highp float;
  uniform float uHorizon;      // height of the horizon in the picture, 0 to 1 from below
  in vec2 vPart;
  out vec4 colour;
  void main() {
    float up = vPart.y - uHorizon;
    vec3 low = vec3(0.052, 0.059, 0.068), mid = vec3(0.105, 0.125, 0.150), high = vec3(0.045, 0.055, 0.072);
    vec3 c = up > 0.0 ? mix(mid, high, smoothstep(0.0, 0.75, up)) : mix(mid, low, smoothstep(0.0, 0.35, -up));
    c += vec3(0.016, 0.019, 0.024) * (1.0 - smoothstep(0.0, 0.75, length((vPart - 0.5) * vec2(1.0, 1.2))));
    float grainy = fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453);
    colour = vec4(c + (grainy - 0.5) / 255.0, 1.0);
  }
`,xh=`
  in vec2 part;
  out vec2 vPart;
  void main() {
    vPart = part;
    gl_Position = vec4(part * 2.0 - 1.0, 1.0, 1.0);
  }
`,nm=`
  precision highp float;
  uniform sampler2D tPicture;
  in vec2 vPart;
  out vec4 colour;
  void main() { colour = texture(tPicture, vPart); }
`;function im(n){let{z:e,min:t}=n.ground,i=new Float32Array(e.length*2);for(let s=0;s<e.length;s++){let r=e[s];i[2*s]=Number.isNaN(r)?-1e4:r-t,i[2*s+1]=n.depth?n.depth[s]:-50}return i}function sm({ground:n,material:e}){if(!e||e.raster.z.length!==n.z.length)return null;let t=new Uint8Array(n.z.length*4);for(let i=0;i<n.z.length;i++){let s=Math.round(e.raster.z[i]),{colour:r,shows:a}=Number.isNaN(s)?Uc(0):e.covers[s]??Uc(s);t[4*i]=r[0],t[4*i+1]=r[1],t[4*i+2]=r[2],t[4*i+3]=Math.round(255*a)}return t}function rm(n){let{ground:e,drainage:t,field:i}=n,s=e.z.length,r=new Uint8Array(s*4);if(i&&i.raster.z.length===s){let a=ls(i.scale.ramp);for(let o=0;o<s;o++){let l=i.raster.z[o],c=Number.isNaN(l)?-1:3*Math.round(255*Ja(l,i.scale));for(let u=0;u<3;u++)r[4*o+u]=c<0?60:a[c+u]}}if(t&&t.z.length===s){let a=s*e.cell[0]*e.cell[1],[o,l]=[Math.log(a*.0025),Math.log(a*.06)];for(let c=0;c<s;c++){let u=(Math.log(Math.max(t.z[c],1e-9))-o)/(l-o);r[4*c+3]=u>0?Math.round(255*Math.min(1,.35+.65*u)):0}}return r}var kb={0:[6,18],1:[14,48],2:[20,80]},am=112,zb={natural:0,field:1,clay:2,sand:3},wa=class{constructor(e){this.mostSquares=e;let t=r=>new ii({glslVersion:Ri,vertexShader:Kp,fragmentShader:em,uniforms:{...this.uniforms,uWall:{value:r}},side:Dn});this.surface=new qt(this.grids.fine,t(0)),this.walls=new qt(gh(1,1),t(1));for(let r of[this.surface,this.walls])r.frustumCulled=!1,this.scene.add(r);let i=new ii({glslVersion:Ri,vertexShader:jp,fragmentShader:Qp,uniforms:this.uniforms,depthTest:!1,depthWrite:!1}),s=new qt(Sa(),i);s.frustumCulled=!1,this.passScene.add(s)}mostSquares;scene=new wi;state=null;ground=null;colours=null;materials=null;shade=new Gt(1,1,{minFilter:mt,magFilter:mt,depthBuffer:!1});roughShade=new Gt(1,1,{minFilter:mt,magFilter:mt,depthBuffer:!1});grids={fine:Ma(1,1),rough:Ma(1,1)};shadedFor="";version=0;passScene=new wi;passCamera=new Ki;uniforms={tGround:{value:null},tColour:{value:null},tMaterial:{value:null},uMaterial:{value:0},tShade:{value:this.shade.texture},uSize:{value:new Ye(1,1)},uNodes:{value:new Ye(2,2)},uTall:{value:1},uSun:{value:new V(0,0,1)},uEye:{value:new V},uRelief:{value:1},uSeaHeight:{value:-1e6},uSnow:{value:2},uLook:{value:0},uContour:{value:0},uHaze:{value:0},uDetail:{value:0},uBrush:{value:new V},uFoot:{value:0},uViewProjection:{value:new lt},uQuick:{value:0},uDirections:{value:16},uRays:{value:64}};surface;walls;show(e){if(e===this.state)return;let{rows:t,cols:i,min:s,max:r,sea:a}=e.ground,o=this.state?.ground;o&&o.rows===t&&o.cols===i||this.resize(t,i),(!o||e.ground!==o||e.depth!==this.state.depth)&&(this.ground.image.data.set(im(e)),this.ground.needsUpdate=!0,this.version++),this.colours.image.data.set(rm(e)),this.colours.needsUpdate=!0;let c=sm(e);this.uniforms.uMaterial.value=c?1:0,c&&(this.materials.image.data.set(c),this.materials.needsUpdate=!0),this.uniforms.uSize.value.set(...vt(e.ground)),this.uniforms.uNodes.value.set(i,t),this.uniforms.uRelief.value=Math.max(r-s,.001),this.uniforms.uSeaHeight.value=a===null?-1e6:a-s,this.state=e}resize(e,t){this.ground?.dispose(),this.colours?.dispose(),this.materials?.dispose(),this.ground=new $i(new Float32Array(e*t*2),t,e,ri,Sn),this.colours=new $i(new Uint8Array(e*t*4),t,e,pn,jt),this.materials=new $i(new Uint8Array(e*t*4),t,e,pn,jt);for(let a of[this.ground,this.colours,this.materials])a.minFilter=a.magFilter=mt,a.wrapS=a.wrapT=Pn,a.generateMipmaps=!1;this.uniforms.tGround.value=this.ground,this.uniforms.tColour.value=this.colours,this.uniforms.tMaterial.value=this.materials,this.shade.setSize(t,e),this.roughShade.setSize(Math.ceil(t/2),Math.ceil(e/2));let i=(a,o)=>Math.max(1,Math.min(a-1,o)),[s,r]=[i(t,this.mostSquares),i(e,this.mostSquares)];this.disposeMeshes(),this.grids={fine:Ma(s,r),rough:Ma(i(t,am),i(e,am))},this.walls.geometry=gh(s,r)}prepare(e,t,i,s,r){let a=this.uniforms,{azimuth:o,height:l}=t.light;a.uSun.value.set(Math.sin(o)*Math.cos(l),Math.cos(o)*Math.cos(l),Math.sin(l)),a.uTall.value=t.tall,a.uEye.value.set(...i),a.uViewProjection.value.copy(s),a.uSnow.value=t.snow,a.uLook.value=zb[t.look],a.uContour.value=t.contour,a.uHaze.value=t.haze,a.uDetail.value=t.detail?1:0,a.uBrush.value.set(...t.brush),a.uFoot.value=-.05*Math.max(a.uSize.value.x,a.uSize.value.y),[a.uDirections.value,a.uRays.value]=kb[r];let c=`${this.version} ${o} ${l} ${t.tall}`;this.surface.geometry=r===0?this.grids.rough:this.grids.fine;let u=r===0?this.roughShade:this.shade;if(a.tShade.value=u.texture,a.uQuick.value=r===0?1:0,this.shadedFor.startsWith(`${c} `)&&Number(this.shadedFor.split(" ").at(-1))>=r){r===0&&!this.shadedFor.endsWith(" 0")&&(a.tShade.value=this.shade.texture);return}this.shadedFor=`${c} ${r}`,e.setRenderTarget(u),e.render(this.passScene,this.passCamera),e.setRenderTarget(null)}forget(){this.shadedFor="",this.state=null,this.ground?.dispose(),this.ground=null}dispose(){this.ground?.dispose(),this.colours?.dispose(),this.materials?.dispose(),this.shade.dispose(),this.roughShade.dispose(),this.disposeMeshes()}disposeMeshes(){this.grids.fine.dispose(),this.grids.rough.dispose(),this.walls.geometry.dispose()}};var cc=class{constructor(e){this.canvas=e;this.software=Jp();let t=e.getContext("webgl2",{alpha:!1,stencil:!1,antialias:!this.software,powerPreference:"high-performance",preserveDrawingBuffer:!1});if(!t)throw new Error("This browser has no WebGL 2. The map still works.");this.renderer=new rc({canvas:e,context:t}),this.renderer.autoClear=!1,this.first=new wa(this.squares()),this.camera.up.set(0,0,1),e.addEventListener("webglcontextrestored",()=>{this.first.forget(),this.second?.forget(),this.redraw()});let i=new qt(Sa(),new ii({glslVersion:Ri,vertexShader:xh,fragmentShader:tm,uniforms:{uHorizon:this.horizon},depthTest:!1,depthWrite:!1})),s=new qt(Sa(),new ii({glslVersion:Ri,vertexShader:xh,fragmentShader:nm,uniforms:{tPicture:{value:this.rough.texture}},depthTest:!1,depthWrite:!1}));i.frustumCulled=s.frustumCulled=!1,this.sky.add(i),this.enlarge.add(s),window.addEventListener("pointerdown",this.hold,!0),window.addEventListener("pointerup",this.letGo,!0),window.addEventListener("pointercancel",this.letGo,!0)}canvas;renderer;camera=new an(_o*180/Math.PI,1,1,10);first;second=null;sky=new wi;rough=new Gt(1,1,{minFilter:mt,magFilter:mt});enlarge=new wi;held=!1;lastTook=0;flat=new Ki;horizon={value:.6};software;quick=!1;drawing=0;asked=!1;settle;size=[1,1];state=null;beside=null;orbit=null;drawn=null;onBegin=()=>{};onDrawn=()=>{};hold=()=>{this.held=!0};letGo=()=>{this.held=!1};squares(){return this.software?192:1024}resize(e,t){this.size=[Math.max(1,e),Math.max(1,t)],this.redraw()}home(){if(!this.state||!this.drawn)return null;let[e,t]=vt(this.state.ground);return sf(e,t,(this.state.ground.max-this.state.ground.min)*this.drawn.tall,this.size[0]/this.size[1])}redraw(e=!1){window.clearTimeout(this.settle),e&&this.settleLater(),this.quick=this.asked?this.quick&&e:e,this.asked=!0,this.drawing||this.begin()}settleLater(){let e=this.software?Math.max(600,3*this.lastTook):180;this.settle=window.setTimeout(()=>this.held?this.settleLater():this.redraw(),e)}begin(){this.drawing=requestAnimationFrame(()=>{let e=performance.now();this.asked=!1,this.onBegin(),this.draw(this.quick),Zp(this.renderer.getContext(),()=>{this.drawing=0,this.lastTook=performance.now()-e,this.onDrawn(this.lastTook),this.asked&&this.begin()})})}draw(e){let{renderer:t,camera:i,state:s,drawn:r}=this,[a,o]=this.size,l=this.software?1:Math.min(window.devicePixelRatio||1,2);this.setSize(Math.round(a*l),Math.round(o*l));let c=e&&this.software,u=c?this.rough:null;c&&this.rough.setSize(Math.ceil(this.canvas.width/2),Math.ceil(this.canvas.height/2)),this.orbit??=this.home();let m=this.orbit;if(!s||!r||!m){t.setScissorTest(!1),t.clear(),t.render(this.sky,this.flat);return}let d=rf(m),[h,_]=vt(s.ground),x=(s.ground.max-s.ground.min)*r.tall,p=Math.hypot(h,_)+x;i.aspect=a/o,i.near=Math.max(m.distance*.02,p*5e-4),i.far=m.distance+p*2,i.position.set(...d),i.lookAt(...m.target),i.updateProjectionMatrix(),i.updateMatrixWorld(),this.horizon.value=.5+Math.tan(m.pitch)/(2*Math.tan(_o/2));let f=new lt().multiplyMatrices(i.projectionMatrix,i.matrixWorldInverse),M=c?0:this.software?1:2;this.first.show(s),this.first.prepare(t,r,d,f,M),this.beside&&(this.second??=new wa(this.squares()),this.second.show(this.beside.state),this.second.prepare(t,r,d,f,M)),t.setRenderTarget(u),this.drawScenes(u?u.width:this.canvas.width,u?u.height:this.canvas.height),t.setRenderTarget(null),u&&t.render(this.enlarge,this.flat)}drawScenes(e,t){let{renderer:i,camera:s}=this,r=(o,l)=>{i.getRenderTarget()?(this.rough.scissorTest=!0,this.rough.scissor.set(o,0,l-o,t),i.setRenderTarget(this.rough)):(i.setScissorTest(!0),i.setScissor(o,0,l-o,t))};if(this.rough.scissorTest=!1,i.setScissorTest(!1),i.clear(),i.render(this.sky,this.flat),!this.beside||!this.second)return void i.render(this.first.scene,s);let a=Math.round(e*this.beside.split);a>0&&(r(0,a),i.render(this.first.scene,s)),a<e&&(r(a,e),i.render(this.second.scene,s)),this.rough.scissorTest=!1,i.setScissorTest(!1)}setSize(e,t){this.canvas.width===e&&this.canvas.height===t||(this.renderer.setPixelRatio(1),this.renderer.setSize(e,t,!1))}ray(e,t){if(!this.orbit)return null;let i=new lt().multiplyMatrices(this.camera.projectionMatrix,this.camera.matrixWorldInverse).invert(),s=l=>Vb(i,e*2-1,1-t*2,l),r=s(-1),a=s(1),o=Math.hypot(a[0]-r[0],a[1]-r[1],a[2]-r[2]);return{from:r,way:[(a[0]-r[0])/o,(a[1]-r[1])/o,(a[2]-r[2])/o]}}dispose(){window.removeEventListener("pointerdown",this.hold,!0),window.removeEventListener("pointerup",this.letGo,!0),window.removeEventListener("pointercancel",this.letGo,!0),this.asked=!1,this.rough.dispose(),cancelAnimationFrame(this.drawing),window.clearTimeout(this.settle),this.first.dispose(),this.second?.dispose(),this.renderer.dispose()}};function Vb(n,e,t,i){let s=n.elements,r=s[3]*e+s[7]*t+s[11]*i+s[15];return[(s[0]*e+s[4]*t+s[8]*i+s[12])/r,(s[1]*e+s[5]*t+s[9]*i+s[13])/r,(s[2]*e+s[6]*t+s[10]*i+s[14])/r]}function Ta(n,e=14){if(!(n>0))return 0;let t=n/e,i=10**Math.floor(Math.log10(t));return[1,2,5,10].map(s=>s*i).find(s=>s>=t)}function om(n,e){let{rows:t,cols:i,z:s}=n,r=[];for(let a=0;a+1<t;a++)for(let o=0;o+1<i;o++){let l=s[a*i+o],c=s[a*i+o+1],u=s[(a+1)*i+o],m=s[(a+1)*i+o+1],d=(l>=e?1:0)|(c>=e?2:0)|(m>=e?4:0)|(u>=e?8:0);d===0||d===15||Number.isNaN(l+c+u+m)||Gb(r,d,o,a,(e-l)/(c-l),(e-c)/(m-c),(e-u)/(m-u),(e-l)/(u-l))}return r}function Gb(n,e,t,i,s,r,a,o){let l=[t+s,i],c=[t+1,i+r],u=[t+a,i+1],m=[t,i+o],d=(h,_)=>n.push(h[0],h[1],_[0],_[1]);switch(e){case 1:case 14:return void d(m,l);case 2:case 13:return void d(l,c);case 3:case 12:return void d(m,c);case 4:case 11:return void d(c,u);case 6:case 9:return void d(l,u);case 7:case 8:return void d(m,u);case 5:return d(m,l),void d(c,u);case 10:return d(l,c),void d(m,u)}}var Cs=[],lm=0,uc=0,Hb=.25;function Pi(){let n=At.value;return n?Math.min(...vt(n))*fi.value:0}function Aa(){let n=rn.value;if(n)return n.typical*zn.value/.3;let e=At.value;return e?Math.max(1,e.max-e.min)*zn.value*.2:0}function ji(n,e){let t=At.value,i=rt.value;if(!t||!i||i==="probe")return;Cs.length===0&&uc===0&&(lm=performance.now());let[s,r]=vt(t),a=[t.origin[0]+n[0]+s/2,t.origin[1]+n[1]+r/2,e||.5,(performance.now()-lm)/1e3];if(rn.value){let o=Cs.at(-1);(!o||Math.hypot(a[0]-o[0],a[1]-o[1])>Hb*Pi())&&Cs.push(a.map(l=>Number(l.toFixed(2))));return}Cs.push(a),uc||=window.setTimeout(cm,40)}function cm(){uc=0;let n=rt.value,e=rn.value;if(!Cs.length||!n)return;let t=Cs;if(Cs=[],!e){je({do:"paint",field:"elevation",tool:n,radius:Pi(),strength:Aa(),points:t});return}let i=Number(ke(Aa(),3));je({do:"stroke",...e.place,tool:n,radius:Math.round(Pi()*10)/10,strength:i,points:t}).then(s=>{s.ok&&Jt(`A stroke of ${e.label} is in the recipe.`)})}function _r(){window.clearTimeout(uc),cm()}var hc=nn(()=>{let n=Xt.value,e=mi.value?.state??null,t=Zn.value?.state??n;return!kt.value||!e||!t?{state:n,beside:null}:kt.value==="flicker"?{state:Lr.value?t:e,beside:null}:{state:e,beside:{state:t,split:Oi.value}}});function dc(n,e){let t=new ResizeObserver(()=>e(n.clientWidth,n.clientHeight));return t.observe(n),e(n.clientWidth,n.clientHeight),()=>t.disconnect()}var yh=[{tool:"probe",label:"Probe: read the ground at a place",key:"q"},{tool:"raise",label:"Raise",key:"w"},{tool:"lower",label:"Lower",key:"e"},{tool:"smooth",label:"Smooth",key:"r"},{tool:"level",label:"Level",key:"t"}];function um(){let n=_n.value?.can??[];return rn.value?yh.filter(e=>e.tool!=="smooth"):n.includes("paint")?yh:yh.filter(e=>e.tool==="probe")}var Ea=Te(!1);function hm(){let n=rt.value,e=rn.value;return g("div",{class:"tools",role:"toolbar","aria-label":"Tools","aria-orientation":"vertical",children:[g(Pe,{icon:"home",label:"The whole land (Home)",kind:"quiet",onClick:()=>kn.value++}),g(Pe,{icon:"sun",label:"Light and height",kind:"quiet",test:"light",pressed:Ea.value,onClick:()=>Ea.value=!Ea.value}),g("hr",{}),um().map(t=>g(Pe,{icon:t.tool,label:`${t.label} (${t.key.toUpperCase()})`,kind:"quiet",test:`tool-${t.tool}`,pressed:n===t.tool,onClick:()=>dm(n===t.tool?null:t.tool)},t.tool)),(Ea.value||n&&n!=="probe")&&g("div",{class:"tool-panel",children:[Ea.value&&g(ft,{children:[g(ks,{label:"Sun from",value:Us.value,low:0,high:360,step:2,text:`${Us.value}°`,onInput:t=>Us.value=t}),g(ks,{label:"Sun height",value:Fs.value,low:4,high:80,step:1,text:`${Fs.value}°`,onInput:t=>Fs.value=t}),g(ks,{label:"Heights",value:Math.log2(ps.value),low:-1,high:4,step:.25,text:`× ${Number(ps.value.toFixed(2))}`,onInput:t=>ps.value=2**t}),g("label",{class:"check",children:[g("input",{type:"checkbox",class:"switch",checked:Tt.value==="map"?Ir.value:Pr.value,onChange:t=>Xb(t.currentTarget.checked)})," Contours"]}),g("label",{class:"check",children:[g("input",{type:"checkbox",class:"switch",checked:io.value,onChange:t=>io.value=t.currentTarget.checked})," Lakes in hollows"]})]}),n&&n!=="probe"&&g(ft,{children:[e&&g("p",{class:"painting",children:[g("span",{children:["Painting ",g("b",{children:e.label})]}),g(Pe,{label:"Ground instead",text:!0,kind:"quiet",onClick:()=>rn.value=null})]}),g(ks,{label:"Radius",value:fi.value,low:.005,high:.3,step:.005,text:Dc(Pi()),onInput:t=>fi.value=t}),g(ks,{label:"Strength",value:zn.value,low:.02,high:1,step:.02,text:Wb(n),onInput:t=>zn.value=t})]})]})]})}function Wb(n){return rn.value?`${ke(Aa(),2)} ${rn.value.unit}`:n==="smooth"?`${Math.round(zn.value*100)} %`:Dc(Aa())}function Xb(n){Tt.value!=="land"&&(Ir.value=n),Tt.value!=="map"&&(Pr.value=n)}function dm(n){rt.value=n,(!n||n==="probe")&&(rn.value=null),n&&!Lt.value&&(Lt.value=[0,0])}function fc(n){if(n.ctrlKey||n.metaKey||n.altKey)return!1;let e=um().find(r=>r.key===n.key.toLowerCase());if(e)return dm(rt.value===e.tool?null:e.tool),!0;let t=At.value;if(!rt.value||!t)return!1;let s={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[n.key];if(s){let[r,a]=vt(t),o=Math.max(r,a)*(n.shiftKey?.05:.01),[l,c]=Lt.value??[0,0],u=(m,d)=>Math.min(d,Math.max(-d,m));return Lt.value=[u(l+s[0]*o,r/2),u(c+s[1]*o,a/2)],!0}switch(n.key){case" ":return Lt.value&&rt.value!=="probe"&&(ji(Lt.value,.5),_r()),!0;case"[":return fi.value=Math.max(.005,fi.value/1.15),!0;case"]":return fi.value=Math.min(.3,fi.value*1.15),!0;case",":return zn.value=Math.max(.02,zn.value/1.2),!0;case";":return zn.value=Math.min(1,zn.value*1.2),!0;default:return!1}}var li=Te(null);function fm(){let n=li.value??(rt.value?Lt.value:null);return At.value?g("output",{class:"readout","data-testid":"readout",children:n?qb(n):g("span",{class:"dim",children:"Drag to turn · Shift-drag to move · Wheel to come nearer · Point to read"})}):null}function qb([n,e]){let t=At.value,[i,s]=vt(t),[r,a]=Qa(t,n,e),o=Ui(t,r,a),l=Nr.value.get("drainage_area"),c=l&&l.rows===t.rows?ja(l,r,a):NaN,u=Xt.value?.depth?ja({...t,z:Xt.value.depth},r,a):NaN,m=[["x",`${Math.round(t.origin[0]+n+i/2).toLocaleString("en")} m`],["y",`${Math.round(t.origin[1]+e+s/2).toLocaleString("en")} m`],["elevation",Number.isNaN(o)?"none":`${ke(o,5)} m`],["slope",`${(Math.atan(Md(t,r,a))*180/Math.PI).toFixed(1)}°`]];Number.isFinite(c)&&m.push(["drains",os(c)]),u>0&&m.push(["water",`${ke(u,3)} m deep`]);let d=Yn.value,h=On.value==="field"&&!["elevation","slope","drainage_area"].includes(d)?Nr.value.get(d):void 0;return h&&m.push([qe(d),ke(ja(h,r,a),4)]),m.map(([_,x])=>g("span",{children:[g("i",{children:_})," ",x]},_))}var Ca=null,pm=0;function gm(){let n=yt(null);return bt(()=>{let e=n.current,t;try{t=new cc(e)}catch(o){vn("error",o.message),Tt.value="map";return}t.orbit=Ca,t.onBegin=lo,t.onDrawn=co;let i=dc(e,(o,l)=>{t.resize(o,l),Ca||(t.orbit=null)}),s=Fn(()=>Yb(t)),r=Zb(t,e),a=kn.subscribe(()=>{kn.value!==0&&(Ca=null,t.orbit=t.home(),t.redraw())});return()=>{i(),s(),r(),a(),t.dispose()}},[]),g("div",{class:"pane",children:g("canvas",{ref:n,role:"application",tabIndex:0,"aria-label":$b(),"data-testid":"land-canvas"})})}function $b(){let n=At.value;return n?`The land in three dimensions, level ${n.level}, from ${Math.round(n.min)} to ${Math.round(n.max)} metres. Arrows turn, plus and minus zoom, Home shows all.`:"The land in three dimensions. No picture yet."}var mm=0;function Yb(n){let{state:e,beside:t}=hc.value,i=Math.PI/180,s=e?Math.max(...vt(e.ground)):1;e&&Math.abs(s/pm-1)>.02&&(Ca=null,n.orbit=null,pm=s),n.state=e,n.beside=t,n.drawn={look:Ur.value,tall:ps.value,light:{azimuth:Us.value*i,height:Fs.value*i},snow:Td.value,contour:Pr.value&&e?Ta(e.ground.max-e.ground.min,24):0,haze:.045/s,detail:!n.software,brush:Lt.value&&rt.value?[...Lt.value,rt.value==="probe"?s*.008:Pi()]:[0,0,0]};let r=performance.now();n.redraw(n.software||r-mm<700),mm=r}function Zb(n,e){let t=null,i=()=>Xt.value?Math.max(...vt(Xt.value.ground)):1,s=_=>{Ca=n.orbit=_,n.redraw(!0)},r=_=>{let x=e.getBoundingClientRect(),p=n.ray((_.clientX-x.left)/x.width,(_.clientY-x.top)/x.height);return p&&At.value?af(At.value,ps.value,p.from,p.way):null},a=_=>{e.focus({preventScroll:!0}),e.setPointerCapture(_.pointerId);let x=_.button===0&&rt.value!==null&&rt.value!=="probe"&&!_.shiftKey;t={x:_.clientX,y:_.clientY,pan:_.button!==0||_.shiftKey,paint:x};let p=x?r(_):null;p&&ji(p,_.pressure)},o=_=>{if(t&&!t.paint&&n.orbit){let[p,f]=[_.clientX-t.x,_.clientY-t.y];t.x=_.clientX,t.y=_.clientY,t.pan?s(eu(n.orbit,-p/e.clientHeight/1.7,f/e.clientHeight/1.2,i())):s(jc(n.orbit,p*.006,f*.005));return}let x=r(_);li.value=x,rt.value&&(Lt.value=x),t?.paint&&x&&ji(x,_.pressure)},l=()=>{t?.paint&&_r(),t=null},h=[["pointerdown",a],["pointermove",o],["pointerup",l],["pointercancel",l],["pointerleave",()=>li.value=null],["wheel",_=>{_.preventDefault(),n.orbit&&s(vo(n.orbit,Math.exp(Math.sign(_.deltaY)*Math.min(Math.abs(_.deltaY),120)*.0016),i()))}],["keydown",_=>{if(fc(_))return void _.preventDefault();let x=n.orbit&&Jb(n.orbit,_,i());if(x)s(x);else if(_.key==="Home")kn.value++;else return;_.preventDefault()}],["contextmenu",_=>_.preventDefault()]];for(let[_,x]of h)e.addEventListener(_,x,{passive:!1});return()=>h.forEach(([_,x])=>e.removeEventListener(_,x))}function Jb(n,e,t){let s={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[e.key];return s&&e.shiftKey?eu(n,s[0]*.04,s[1]*.04,t):s?jc(n,s[0]*.08,s[1]*.06):e.key==="+"||e.key==="="?vo(n,.88,t):e.key==="-"||e.key==="−"?vo(n,1/.88,t):null}function _m(n){let{ground:e,depth:t,field:i}=n,{rows:s,cols:r,z:a,cell:o}=e,l=i?.scale??bh(n),c=i&&i.raster.z.length===a.length?i.raster.z:a,u=ls(l.ramp),m=ls("depth"),d=t?Math.max(1e-6,...Kb(t)):1,h=new Uint8ClampedArray(s*r*4),_=Qb(n);for(let x=0;x<s;x++){let p=Math.max(0,x-1)*r,f=Math.min(s-1,x+1)*r;for(let M=0;M<r;M++){let A=x*r+M,S=c[A];if(Number.isNaN(a[A]))continue;let C=(a[x*r+Math.min(r-1,M+1)]-a[x*r+Math.max(0,M-1)])/(2*o[0])*_,E=(a[p+M]-a[f+M])/(2*o[1])*_,v=t!==null&&t[A]>0&&!i,w=v?3*Math.round(255*(.25+.7*Math.sqrt(Math.min(1,t[A]/d)))):3*Math.round(255*Ja(S,l)),B=v?m:u,L=v?.86:eM(C,E),D=4*A;for(let k=0;k<3;k++)h[D+k]=B[w+k]*L;h[D+3]=255}}return h}function bh({ground:n}){let e=n.sea!==null&&n.sea>n.min&&n.sea<n.max?n.sea:n.min;return Za("elevation",e,n.max)}function*Kb(n){let e=Math.max(1,Math.floor(n.length/4096));for(let t=0;t<n.length;t+=e)yield n[t]}function Qb({ground:n}){let e=(n.max-n.min)/(Math.min(n.cols*n.cell[0],n.rows*n.cell[1])||1);return Math.min(40,Math.max(.8,.12/Math.max(e,1e-6)))}var jb=[315,270,360,225].map((n,e)=>{let t=n*Math.PI/180,i=38*Math.PI/180;return[Math.sin(t)*Math.cos(i),Math.cos(t)*Math.cos(i),Math.sin(i),[.55,.15,.2,.1][e]]});function eM(n,e){let t=Math.sqrt(n*n+e*e+1),i=0;for(let[s,r,a,o]of jb)i+=o*Math.max(0,-n*s-e*r+a)/t;return .4+.97*i}var tM={elevation:"m",slope:"°",drainage_area:"m²",lake_depth:"m"};function vm(){let n=Xt.value,e=yt(null),t=n?.field??null,i=t?.scale??(n&&Tt.value!=="land"?bh(n):null),s=i?.ramp;if(bt(()=>{let l=e.current;if(!l||!s)return;let c=ls(s),u=l.getContext("2d"),m=u.createImageData(256,1);for(let d=0;d<256;d++){for(let h=0;h<3;h++)m.data[4*d+h]=c[3*d+h];m.data[4*d+3]=255}u.putImageData(m,0,0)},[s]),!i)return null;let r=t?Yn.value:"elevation",a=tM[r]??Ds.value.find(l=>l.name===r)?.unit.replace("m2","m²")??"",o=(l,c)=>a==="m²"?os(l):ke(l,c);return g("div",{class:"legend","data-testid":"legend",children:[g("span",{class:"legend-name",children:[qe(r),a&&a!=="1"&&a!=="m²"?`, ${a}`:"",i.log?" (log)":""]}),g("canvas",{ref:e,width:256,height:1}),g("span",{class:"legend-ends",children:[g("span",{children:o(i.low,3)}),g("span",{children:o(i.high,4)})]})]})}var pc=class{constructor(e){this.canvas=e;this.context=e.getContext("2d",{alpha:!1})}canvas;context;painted=new Map;pending=0;size=[1,1];state=null;beside=null;contours=!0;brush=[0,0,0];place={east:0,north:0,zoom:1};onDrawn=()=>{};resize(e,t){this.size=[Math.max(1,e),Math.max(1,t)],this.redraw()}redraw(){this.pending||=requestAnimationFrame(()=>{this.pending=0,this.draw()})}scale(e){let[t,i]=vt(e.ground);return Math.min((this.size[0]-32)/t,(this.size[1]-32)/i)*this.place.zoom}toGround(e,t){if(!this.state)return null;let i=this.scale(this.state);return[this.place.east+(e-.5)*this.size[0]/i,this.place.north-(t-.5)*this.size[1]/i]}metres(e){return this.state?e/this.scale(this.state):0}draw(){let e=performance.now(),{canvas:t,context:i,state:s}=this,r=Math.min(window.devicePixelRatio||1,2),[a,o]=this.size;if(t.width!==Math.round(a*r)&&(t.width=Math.round(a*r)),t.height!==Math.round(o*r)&&(t.height=Math.round(o*r)),i.setTransform(r,0,0,r,0,0),i.fillStyle="#0b0d10",i.fillRect(0,0,a,o),!!s){if(this.forget(),this.beside){let l=a*this.beside.split;this.clipped(0,l,()=>this.one(s)),this.clipped(l,a,()=>this.one(this.beside.state))}else this.one(s);this.drawBrush(s),this.drawScaleBar(s),this.onDrawn(performance.now()-e)}}forget(){for(let e of this.painted.keys())e!==this.state&&e!==this.beside?.state&&this.painted.delete(e)}clipped(e,t,i){this.context.save(),this.context.beginPath(),this.context.rect(e,0,t-e,this.size[1]),this.context.clip(),i(),this.context.restore()}one(e){let{context:t}=this,i=this.paint(e),{ground:s}=e,[r,a]=vt(s),o=this.scale(e),l=this.size[0]/2-(this.place.east+r/2)*o,c=this.size[1]/2+(this.place.north-a/2)*o;t.imageSmoothingEnabled=!0,t.imageSmoothingQuality="high";let[u,m]=[s.cell[0]*o/2,s.cell[1]*o/2];if(t.drawImage(i.picture,l-u,c-m,r*o+2*u,a*o+2*m),!!this.contours){i.lines??=nM(e),t.save(),t.translate(l,c),t.scale(s.cell[0]*o,s.cell[1]*o);for(let{path:d,strong:h}of i.lines??[])t.lineWidth=(h?1.3:.7)/(s.cell[0]*o),t.strokeStyle=h?"rgba(15,12,8,.6)":"rgba(15,12,8,.36)",t.stroke(d);t.restore()}}paint(e){let t=this.painted.get(e);if(!t){let i=document.createElement("canvas");i.width=e.ground.cols,i.height=e.ground.rows,i.getContext("2d").putImageData(new ImageData(_m(e),e.ground.cols,e.ground.rows),0,0),t={state:e,picture:i,lines:null},this.painted.set(e,t)}return t}drawBrush(e){let[t,i,s]=this.brush;if(!(s>0))return;let r=this.scale(e),{context:a}=this;a.beginPath(),a.arc(this.size[0]/2+(t-this.place.east)*r,this.size[1]/2-(i-this.place.north)*r,s*r,0,2*Math.PI),a.lineWidth=3,a.strokeStyle="rgba(0,0,0,.5)",a.stroke(),a.lineWidth=1.5,a.strokeStyle="#ffd479",a.stroke()}drawScaleBar(e){let{context:t}=this,i=this.scale(e),s=Ta(150/i,1.2),[r,a]=[66,this.size[1]-58],o=s>=1e3?`${s/1e3} km`:`${s} m`;t.lineWidth=3,t.strokeStyle="rgba(10,12,14,.75)";let l=()=>{t.beginPath(),t.moveTo(r,a-5),t.lineTo(r,a),t.lineTo(r+s*i,a),t.lineTo(r+s*i,a-5),t.stroke()};l(),t.lineWidth=1.4,t.strokeStyle="#f2eee6",l(),t.font="12px system-ui, sans-serif",t.lineWidth=3,t.strokeStyle="rgba(10,12,14,.75)",t.strokeText(o,r+5,a-7),t.fillStyle="#f2eee6",t.fillText(o,r+5,a-7)}};function nM({ground:n}){let e=Ta(n.max-n.min,16),t=[];if(!(e>0))return t;for(let i=Math.ceil(n.min/e)*e,s=0;i<n.max&&s<64;i+=e,s++){let r=om(n,i),a=new Path2D;for(let o=0;o<r.length;o+=4)a.moveTo(r[o],r[o+1]),a.lineTo(r[o+2],r[o+3]);t.push({path:a,strong:Math.round(i/e)%5===0})}return t}function xm(){let n=yt(null);bt(()=>{let t=n.current,i=new pc(t);i.onDrawn=()=>{Tt.value==="map"&&(lo(),co())};let s=dc(t,(l,c)=>i.resize(l,c)),r=Fn(()=>{let{state:l,beside:c}=hc.value;i.state=l,i.beside=c,i.contours=Ir.value;let u=l?Math.max(...vt(l.ground)):1;i.brush=Lt.value&&rt.value?[...Lt.value,rt.value==="probe"?u*.008:Pi()]:[0,0,0],i.redraw()}),a=iM(i,t),o=kn.subscribe(()=>{i.place={east:0,north:0,zoom:1},i.redraw()});return()=>{s(),r(),a(),o()}},[]);let e=At.value;return g("div",{class:"pane",children:g("canvas",{ref:n,role:"application",tabIndex:0,"data-testid":"map-canvas","aria-label":e?`Map of the land, level ${e.level}, north is up. Arrows move, plus and minus zoom, Home shows all.`:"Map of the land. No picture yet."})})}function iM(n,e){let t=null,i=([x,p])=>{let f=At.value;if(!f)return!1;let[M,A]=vt(f);return Math.abs(x)<=M/2&&Math.abs(p)<=A/2},s=x=>{let p=e.getBoundingClientRect();return n.toGround((x.clientX-p.left)/p.width,(x.clientY-p.top)/p.height)},r=(x,p)=>{n.place={...n.place,east:n.place.east-n.metres(x),north:n.place.north+n.metres(p)},n.redraw()},a=(x,p)=>{let f=n.place,M=Math.min(64,Math.max(.5,f.zoom*x)),A=p??[f.east,f.north],S=f.zoom/M;n.place={zoom:M,east:A[0]+(f.east-A[0])*S,north:A[1]+(f.north-A[1])*S},n.redraw()},o=x=>{e.focus({preventScroll:!0}),e.setPointerCapture(x.pointerId);let p=x.button===0&&rt.value!==null&&rt.value!=="probe"&&!x.shiftKey;t={x:x.clientX,y:x.clientY,paint:p};let f=s(x);p&&f&&i(f)&&ji(f,x.pressure)},l=x=>{if(t&&!t.paint){r(x.clientX-t.x,x.clientY-t.y),t.x=x.clientX,t.y=x.clientY;return}let p=s(x);li.value=p&&i(p)?p:null,rt.value&&(Lt.value=li.value),t?.paint&&li.value&&ji(li.value,x.pressure)},c=()=>{t?.paint&&_r(),t=null},_=[["pointerdown",o],["pointermove",l],["pointerup",c],["pointercancel",c],["pointerleave",()=>li.value=null],["wheel",x=>{x.preventDefault(),a(Math.exp(-Math.sign(x.deltaY)*Math.min(Math.abs(x.deltaY),120)*.0018),s(x))}],["keydown",x=>{let f={ArrowLeft:[60,0],ArrowRight:[-60,0],ArrowUp:[0,60],ArrowDown:[0,-60]}[x.key];if(!fc(x))if(f)r(...f);else if(x.key==="+"||x.key==="=")a(1.25,null);else if(x.key==="-")a(.8,null);else if(x.key==="Home")kn.value++;else return;x.preventDefault()}],["contextmenu",x=>x.preventDefault()]];for(let[x,p]of _)e.addEventListener(x,p,{passive:!1});return()=>_.forEach(([x,p])=>e.removeEventListener(x,p))}var sM=[{value:"land",label:"3-D"},{value:"map",label:"Map"},{value:"both",label:"Both"}];function ym(){return g("main",{class:"views",children:[g("div",{class:`panes ${Tt.value}`,children:[Tt.value!=="map"&&g(gm,{}),Tt.value!=="land"&&g(xm,{}),kt.value==="wipe"&&g(lM,{}),!Xt.value&&g("p",{class:"no-land",children:Qe.value?.errors.length?"The recipe has a mistake; mend it and the land grows again.":"The first preview is on its way…"})]}),g(rM,{}),g("div",{class:"view-choices",children:[g(oM,{}),g(kr,{label:"view",value:Tt.value,choices:sM,onChange:n=>Tt.value=n})]}),g(hm,{}),g(fm,{}),g(vm,{}),kt.value&&g(cM,{})]})}function rM(){let n=It.value,e=Xt.value?.ground,t=di.value!==null?Qe.value?.stages[di.value]:null;return g("div",{class:"level","data-testid":"level",children:[g("b",{children:aM(e?.level??n?.level??null)}),e&&g("span",{children:[e.cols," × ",e.rows]}),n?.settling&&g("span",{class:"settling",children:"settling"}),n?.running&&!n.paused&&!n.settling&&g("span",{class:"busy",children:"working"}),un.value!==null&&g("span",{class:"settling",children:"a picture of the past"}),t&&g("span",{class:"settling",children:["after ",qe(t.use).toLowerCase()]})]})}function aM(n){return n?n==="build"||n==="1"||n==="1/1"?"full size":`preview ${n}`:"no picture yet"}function oM(){let n=new Map(Ds.value.map(i=>[i.name,i.unit]));for(let i of["elevation","slope","drainage_area"])n.has(i)||n.set(i,"");let e=On.value==="field"?`field:${Yn.value}`:On.value,t=i=>{i.startsWith("field:")?(Yn.value=i.slice(6),On.value="field",uo()):On.value=i};return g("select",{class:"field compact","aria-label":"Colours","data-testid":"colours",value:e,onChange:i=>t(i.currentTarget.value),children:[g("option",{value:"auto",children:Dr.value?"Sand (by the recipe)":"Natural"}),Ur.value!=="sand"&&g("option",{value:"sand",children:"Sand"}),Dr.value&&g("option",{value:"natural",children:"Natural"}),g("option",{value:"clay",children:"Clay"}),g("optgroup",{label:"Fields",children:[...n.keys()].map(i=>g("option",{value:`field:${i}`,children:qe(i)},i))})]})}function lM(){let n=yt(null),e=t=>{let i=n.current.parentElement.getBoundingClientRect();Oi.value=Math.min(1,Math.max(0,(t.clientX-i.left)/i.width))};return g("div",{ref:n,class:"wipe",role:"slider",tabIndex:0,"aria-label":"Wipe between A and B","aria-valuemin":0,"aria-valuemax":100,"aria-valuenow":Math.round(Oi.value*100),style:{left:`${Oi.value*100}%`},onPointerDown:t=>{t.currentTarget.setPointerCapture(t.pointerId),t.preventDefault()},onPointerMove:t=>t.buttons&1&&e(t),onKeyDown:t=>{let i={ArrowLeft:-.02,ArrowRight:.02,Home:-1,End:1}[t.key];i!==void 0&&(t.preventDefault(),Oi.value=Math.min(1,Math.max(0,Oi.value+i)))},children:[g("i",{}),g("b",{class:"chip at-left",children:"A"}),g("b",{class:"chip at-right",children:"B"})]})}function cM(){return bt(()=>{if(kt.value!=="flicker")return;let e=window.matchMedia("(prefers-reduced-motion: reduce)").matches,t=window.setInterval(()=>Lr.value=!Lr.value,e?2500:700);return()=>window.clearInterval(t)},[kt.value]),g("div",{class:"compare-bar","data-testid":"compare",children:[g("span",{children:[g("b",{class:"chip",children:"A"})," ",((e,t)=>e?.name??t)(mi.value,"nothing kept").replace(/^A: /,"")]}),g(Pe,{label:"Keep as A",text:!0,kind:"quiet",test:"keep-a",onClick:()=>Br("A")}),g("span",{children:[g("b",{class:"chip",children:"B"})," ",Zn.value?Zn.value.name.replace(/^B: /,""):"what is shown now"]}),g(Pe,{label:"Keep as B",text:!0,kind:"quiet",test:"keep-b",onClick:()=>Br("B")}),Zn.value&&g(Pe,{label:"B follows",text:!0,kind:"quiet",title:"B is what is shown now",onClick:()=>Zn.value=null}),g(kr,{label:"compare",value:kt.value,choices:[{value:"wipe",label:"Wipe"},{value:"flicker",label:"Flicker"}],onChange:e=>kt.value=e}),g(Pe,{icon:"close",label:"End the comparison",kind:"quiet",onClick:()=>kt.value=null})]})}function bm(){Vd();let n=Bn.value&&Qe.value!==null&&!Os.value;return g("div",{class:`app ${n?"empty":""} ${Zt.value==="text"?"texting":""}`,"data-testid":"app","data-ready":Qe.value&&(n||Xt.value)?"true":"false",children:[g(kd,{}),n?g(Ud,{}):g(ft,{children:[g(tf,{}),g(ym,{}),g(Qd,{}),g(Bd,{})]}),!Bn.value&&_n.value&&g("p",{class:"lost",role:"alert",children:"The studio does not answer. The page tries again; if the program has ended, start it and open the address that it prints."}),g(Gd,{}),g("div",{class:"said",role:"status","aria-live":"polite",children:Fc.value}),st.value==="gallery"&&g(Fd,{}),st.value==="add"&&g(jd,{}),st.value==="export"&&g(Dd,{}),st.value==="contact"&&g(Ld,{}),st.value==="keys"&&g(zd,{})]})}var Mm=document.getElementById("studio");Mm.textContent="";Xh(g(bm,{}),Mm);Ed();
