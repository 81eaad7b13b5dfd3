MathJax.Hub.Config({ messageStyle: "none", showMathMenu: false, menuSettings: { zoom: "None" } });
