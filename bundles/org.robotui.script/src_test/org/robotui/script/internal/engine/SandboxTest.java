package org.robotui.script.internal.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.api.script.ScriptFailure;
import org.robotui.api.script.ScriptFunction;
import org.robotui.api.script.ScriptOutcome;
import org.robotui.api.script.ScriptOutcome.Failed;
import org.robotui.api.script.ScriptOutcome.Stopped;

class SandboxTest {
  private static final ScriptFunction FAILS = ScriptFunction.of("fails()", "Fails.", "", call -> {
    throw new ScriptFailure("it cannot be done");
  });
  private static final ScriptFunction BROKEN = ScriptFunction.of("broken()", "Is wrong.", "", call -> {
    throw new IllegalStateException("no font");
  });

  @ParameterizedTest
  @ValueSource(strings = {"java.lang.System.exit(1)", "Packages.java.io.File", "new java.io.File('/')",
      "importClass(x)", "JavaAdapter", "getClass()", "new JavaImporter()", "loadClass('x')",
      "Java.type('java.lang.System')", "java", "load2", "require('fs')", "XML('<a/>')"})
  void noClassCanBeReached(String script) {
    try (Console console = new Console()) {
      assertInstanceOf(Failed.class, console.run(script));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"print.getClass()", "uis().getClass()", "''.getClass()",
      "try { fails(); } catch (e) { e.javaException.getClass(); }",
      "try { fails(); } catch (e) { e.rhinoException.getClass(); }",
      "uis.constructor('return java')()", "(function(){}).constructor('return Packages')()"})
  void noObjectOfJavaIsSeen(String script) {
    try (Console console = new Console(FAILS)) {
      assertInstanceOf(Failed.class, console.run(script));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"while (true) {}", "eval('for (;;) {}')", "new Function('for (;;) ;')()",
      "while (true) { try { while (true) {} } catch (e) {} }", "try { for (;;) {} } finally { for (;;) {} }",
      "[3, 2, 1].sort(() => { for (;;) {} })", "'aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaab'.match(/^(a+)+$/)",
      "while (true) { uis(); }", "waitFor(() => { while (true) {} })",
      "function* g() { for (;;) yield 1; } for (let x of g()) {}",
      "var o = {get x() { for (;;) {} }}; o.x", "var o = {get x() { for (;;) {} }}; o"})
  void anEndlessLoopIsStopped(String script) {
    try (Console console = new Console(Duration.ofMillis(300), new HeapLook())) {
      Stopped stopped = assertInstanceOf(Stopped.class, console.run("1;", script));
      assertTrue(stopped.reason().contains("without waiting"), stopped.reason());
      assertEquals("test.js:2: ", stopped.toString().substring(0, 11), stopped.toString());
      assertEquals(3.0, console.value("1 + 2"), "and the session goes on");
    }
  }

  @Test
  void aLoopThatWaitsGoesOnUntilItIsStopped() throws InterruptedException {
    try (Console console = new Console(Duration.ofMillis(200), new HeapLook())) {
      Thread user = Thread.ofPlatform().daemon().start(() -> {
        while (console.printed.size() < 40) {
          Thread.onSpinWait();
        }
        console.session.stop("you stopped it");
      });
      ScriptOutcome outcome = console.run("while (true) {", "  try { sleep(0.01); print('beat'); } catch (e) {}", "}");
      user.join();
      assertEquals(new Stopped("you stopped it", "test.js", 2), outcome);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"function f() { f(); } f()", "var f = () => f(); f()",
      "var a = []; a[0] = a; a", "function f(x) { return [1].map(() => f(x)); } f(1)",
      "var o = {toString() { return '' + o; }}; '' + o", "'x'.repeat(2e9)", "'x'.padStart(2e9)",
      "var s = 'x'; while (true) { s += s; }", "JSON.stringify(eval('('.repeat(1e5) + ')'.repeat(1e5)))",
      "eval('['.repeat(1e5))", "JSON.parse('['.repeat(1e5))"})
  void whatIsTooLargeFails(String script) {
    try (Console console = new Console()) {
      ScriptOutcome outcome = console.run(script);
      assertTrue(outcome instanceof Failed || outcome instanceof Stopped, outcome.toString());
      assertEquals(3.0, console.value("1 + 2"), "and the session goes on");
    }
  }

  @Test
  void aScriptThatFillsTheMemoryIsStopped() {
    HeapLook full = new HeapLook() {
      @Override
      boolean isFull() {
        return true;
      }
    };
    try (Console console = new Console(Duration.ofSeconds(20), full)) {
      Stopped stopped = assertInstanceOf(Stopped.class, console.run("var a = []; while (true) a.push({});"));
      assertTrue(stopped.reason().contains("memory"), stopped.reason());
    }
  }

  @Test
  void errorsNameFileAndLine() {
    try (Console console = new Console(FAILS, BROKEN)) {
      assertEquals("test.js:2: it cannot be done", console.failure("1;", "fails();"));
      assertEquals("test.js:3: ReferenceError: \"nothing\" is not defined.", console.failure("1;", "2;", "nothing();"));
      assertEquals("test.js:2: syntax error", console.failure("1;", "(1 + ;", "2"));
      assertEquals("test.js:2: my own", console.failure("function f() {", "throw new Error('my own');", "}", "f();"));
      assertEquals("test.js:1: it is called fails(), and was given 1 argument", console.failure("fails(1)"));
      assertTrue(console.failure("broken()").contains("a fault of its bundle"));
    }
  }

  @Test
  void aScriptCanCatchWhatFails() {
    try (Console console = new Console(FAILS)) {
      assertEquals("it cannot be done", console.value("try { fails(); } catch (e) { e.message; }"));
      assertEquals("Error 1", console.value("try { fails(); } catch (e) { e.name + ' ' + e.lineNumber; }"));
    }
  }

  @Test
  void variablesLastAndOurNamesCanBeTaken() {
    try (Console console = new Console()) {
      console.run("var value = 7; let other = [1, {a: 'b'}];");
      assertEquals(7.0, console.value("value"));
      assertEquals(List.of(1.0, Map.of("a", "b")), console.value("other"));
    }
  }

  @Test
  void theLanguageIsThere() {
    try (Console console = new Console()) {
      assertEquals("1-2", console.value("const {a, b} = {a: 1, b: 2}; `${a}-${b}`"));
      assertEquals(6.0, console.value("[1, 2, 3].reduce((x, y) => x + y)"));
      assertEquals("b", console.value("'abc'.match(/b/)[0]"));
      assertEquals(2.0, console.value("let n = 0; for (let x of new Set([1, 1, 2])) n++; n"));
      assertEquals("abab", console.value("'ab'.repeat(2)"));
    }
  }

  @Test
  void anExitCannotBeCaught() {
    try (Console console = new Console()) {
      assertEquals(new ScriptOutcome.Exited(3), console.run("try { exit(3); } catch (e) {} finally { print('x'); }"));
      assertEquals(new ScriptOutcome.Exited(0), console.run("exit()"));
      assertTrue(console.failure("exit(1.5)").contains("whole number"));
    }
  }

  @Test
  void whatIsDisturbedInOneSessionIsWholeInTheNext() {
    try (Console one = new Console(); Console other = new Console()) {
      one.run("Array.prototype.map = () => 'broken'; Object.prototype.x = 1;");
      assertEquals("broken", one.value("[1].map()"));
      assertEquals(List.of(2.0), other.value("[1].map(x => x + 1)"));
    }
  }

  @Test
  void functionsOfBundlesThatGoAreGone() {
    try (Console console = new Console(FAILS)) {
      assertFalse(console.session.complete("fai").words().isEmpty());
      assertEquals(List.of("fails"), console.session.complete("x = fai").words());
      assertEquals(List.of(), console.session.complete("x.fai").words());
    }
  }
}
