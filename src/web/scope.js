// What the code that emscripten writes looks for in the scope around it. Where the script of its worker is, it does not
// need to know; with what it starts threads, who makes an instance says (module/tool.js).
var self = { 'location': { 'href': '' } };
var Worker = Module['Worker'], postMessage = Module['postMessage'];
var navigator = { 'hardwareConcurrency': Module['processors'] };
