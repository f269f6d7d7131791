package org.robotui.uic.console.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StyledText;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.testkit.FakeScripts;
import org.robotui.api.script.ScriptOutcome;
import org.robotui.api.script.ScriptSession.Completion;
import org.robotui.testkit.Controls;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.control.QuietButton;

class ConsoleSwtTest {
  private final FakeScripts scripts = new FakeScripts();
  private final ConsoleType type = new ConsoleType(scripts);
  private final FakeUicContext context = new FakeUicContext("console", type.schema());
  private final ConsoleUic console = new ConsoleUic(context, scripts);
  private Theme theme;
  private Shell shell;
  private StyledText output;
  private StyledText field;

  @BeforeEach
  void open() {
    theme = Themes.of(TestDisplay.get(), "dark");
    shell = new Shell(TestDisplay.get());
    shell.setLayout(new FillLayout());
    shell.setSize(600, 400);
    console.createControl(shell, UiContext.of(theme, note -> {}));
    shell.open();
    List<StyledText> texts = Controls.all(shell, StyledText.class);
    output = texts.getFirst();
    field = texts.getLast();
    context.background(Runnable::run);
  }

  @AfterEach
  void close() {
    console.close();
    shell.dispose();
    theme.dispose();
  }

  @Test
  void whatIsTypedRunsInTheRobotUiOfTheView() {
    assertTrue(scripts.opened.isEmpty(), "a console that nobody uses is nobody");
    type("1 + 1");
    key(SWT.CR, 0);
    assertEquals(List.of("the console of " + context.ruic().name()), scripts.opened);
    assertEquals("use(\"" + context.ruic().name() + "\");", scripts.runs.getFirst().text());
    assertEquals("1 + 1", scripts.runs.getLast().text());
    assertTrue(stop().getVisible());
    scripts.output.accept("printed");
    scripts.end(new ScriptOutcome.Done(Optional.of(2), "2"));
    assertTrue(console.tick(0));
    console.refresh();
    assertTrue(output.getText().endsWith("> 1 + 1\nprinted\n2\n"), output.getText());
    assertFalse(stop().getVisible());
    assertEquals(List.of("1 + 1"), context.settings().current().list(ConsoleType.HISTORY));
    assertFalse(console.tick(0), "nothing is new");
  }

  @Test
  void whatTheUserDoesIsWrittenDownAndSaved(@TempDir Path folder) throws Exception {
    ViewAction record = console.actions().stream().filter(a -> a.id().equals("record")).findFirst().orElseThrow();
    record.run().run();
    assertTrue(record.checked().orElseThrow().getAsBoolean());
    scripts.recorded.accept("openView(\"map\", \"Natalie\");");
    record.run().run();
    assertFalse(record.checked().orElseThrow().getAsBoolean());
    scripts.recorded.accept("closeView(\"map\", \"Natalie\");");
    console.refresh();
    assertTrue(output.getText().contains("openView(\"map\", \"Natalie\");\nrecorded;"), output.getText());
    console.hands().save(folder.resolve("done.js"));
    assertEquals("openView(\"map\", \"Natalie\");\n", Files.readString(folder.resolve("done.js")));
  }

  @Test
  void errorsNameTheLine() {
    type("nothing()");
    key(SWT.CR, 0);
    scripts.end(new ScriptOutcome.Failed("\"nothing\" is not defined", "console", 1));
    console.refresh();
    assertTrue(output.getText().contains("console:1: \"nothing\" is not defined"), output.getText());
    assertEquals(theme.color(Role.BAD),
        output.getStyleRangeAtOffset(output.getText().indexOf("console:1")).foreground);
  }

  @Test
  void anOpenBracketGoesOnInTheNextLine() {
    type("while (true) {");
    key(SWT.CR, 0);
    assertTrue(scripts.runs.isEmpty());
    assertEquals(2, field.getLineCount());
    type("sleep(1) }");
    key(SWT.CR, 0);
    assertEquals("while (true) {\nsleep(1) }", scripts.runs.getLast().text());
    assertEquals("", field.getText());
  }

  @Test
  void escStopsWhatRunsAndElseClears() {
    type("x");
    key(SWT.ESC, 0);
    assertEquals("", field.getText());
    type("sleep(9)");
    key(SWT.CR, 0);
    assertFalse(scripts.stopped);
    key(SWT.ESC, 0);
    assertTrue(scripts.stopped);
  }

  @Test
  void arrowsBringBackWhatWasTyped() {
    type("first()");
    key(SWT.CR, 0);
    type("sec");
    key(SWT.ARROW_UP, 0);
    assertEquals("first()", field.getText());
    key(SWT.ARROW_DOWN, 0);
    assertEquals("sec", field.getText());
  }

  @Test
  void tabCompletes() {
    type("let a = takeC");
    scripts.completion = new Completion(8, List.of("takeControl"));
    key(SWT.TAB, 0);
    assertEquals("let a = takeControl", field.getText());
    field.setText("");
    type("per");
    scripts.completion = new Completion(0, List.of("perspective", "perspectives"));
    key(SWT.TAB, 0);
    assertEquals("perspective", field.getText());
  }

  @Test
  void aFileRunsAndWhatWasTypedIsSaved(@TempDir Path folder) throws Exception {
    Path script = Files.writeString(folder.resolve("patrol.js"), "drive(0.1, 0, 1)");
    console.hands().open(script);
    assertEquals("patrol.js", scripts.runs.getLast().name());
    scripts.end(new ScriptOutcome.Done(Optional.empty(), ""));
    console.hands().open(folder.resolve("none.js"));
    type("ports()");
    key(SWT.CR, 0);
    scripts.end(new ScriptOutcome.Done(Optional.empty(), ""));
    type("bad()");
    key(SWT.CR, 0);
    scripts.end(new ScriptOutcome.Stopped("it was stopped", "console", 1));
    console.hands().save(folder.resolve("kept.js"));
    assertEquals("ports()\n", Files.readString(folder.resolve("kept.js")));
    console.refresh();
    assertTrue(output.getText().contains("none.js is not there"), output.getText());
    assertTrue(output.getText().contains("console:1: it was stopped"), output.getText());
  }

  @Test
  void closingTheViewEndsItsSession() {
    type("takeControl()");
    key(SWT.CR, 0);
    console.close();
    assertTrue(scripts.closed);
  }

  @Test
  void aFloodOfOutputStaysBounded() {
    type("while (true) print('on')");
    key(SWT.CR, 0);
    for (int i = 0; i < 10_000; i++) {
      scripts.output.accept("line " + i);
      if (i % 1000 == 0) {
        console.refresh();
      }
    }
    console.refresh();
    assertTrue(output.getText().endsWith("line 9999\n"));
    assertTrue(output.getLineCount() <= 2001, output.getLineCount() + " lines");
  }

  private QuietButton stop() {
    return Controls.all(shell, QuietButton.class).getLast();
  }

  private void type(String words) {
    field.insert(words);
    field.setCaretOffset(field.getCaretOffset() + words.length());
  }

  private void key(int code, int mask) {
    Event event = new Event();
    event.keyCode = code;
    event.character = code == SWT.CR || code == SWT.TAB || code == SWT.ESC ? (char) code : 0;
    event.stateMask = mask;
    field.notifyListeners(SWT.KeyDown, event);
  }
}
