package org.robotui.uic.postures.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.port.PluginReply;
import org.robotui.api.port.PluginRequest;
import org.robotui.data.control.ControlPlugins.State;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeCaller;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.uic.postures.internal.view.SurfaceHands;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class PosturesSwtTest {
  private final Display display = TestDisplay.get();
  private final FakeUicContext context = new FakeUicContext("postures", new PosturesType().schema());
  private final FakeCaller<PluginRequest, PluginReply> caller = new FakeCaller<>(ArmNow.VERBS);
  private PosturesUic uic;
  private SurfaceHands hands;
  private Theme theme;
  private Shell shell;
  private String note = "";

  @BeforeEach
  void open() {
    context.caller(PosturesPorts.VERBS, caller);
    new ArmNow(context).at(0.4, -0.2).plugin(State.RUNNING, "holding");
    theme = Themes.dark(display);
    shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, 700, 400);
    uic = new PosturesUic(context);
    uic.tick(1);
    Control made = uic.createControl(shell, UiContext.of(theme, text -> note = text));
    shell.open();
    shell.layout(true, true);
    hands = new SurfaceHands(uic.shown());
    assertTrue(made.isVisible());
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  private void key(int code, int modifiers) {
    Event event = new Event();
    event.keyCode = code;
    event.stateMask = modifiers;
    hands.list().notifyListeners(SWT.KeyDown, event);
  }

  private List<String> names() {
    return uic.model().sequence().postures().stream().map(posture -> posture.name()).toList();
  }

  @Test
  void keysStoreOrderRemoveAndUndo() {
    hands.store();
    key(SWT.INSERT, SWT.NONE);
    assertEquals(List.of("Posture 1", "Posture 2"), names());
    assertEquals("2 postures", note);
    key(SWT.ARROW_UP, SWT.ALT);
    assertEquals(List.of("Posture 2", "Posture 1"), names());
    key(SWT.DEL, SWT.NONE);
    assertEquals(List.of("Posture 1"), names(), "what was moved is still selected");
    key('z', SWT.MOD1);
    assertEquals(List.of("Posture 2", "Posture 1"), names());
  }

  @Test
  void runAndStopAreOneButtonAndEscEndsItToo() {
    hands.store();
    hands.play();
    assertEquals("1 posture \u00b7 running", note);
    hands.play();
    assertEquals("1 posture", note);
    hands.play();
    key(SWT.ESC, SWT.NONE);
    assertEquals("Stopped on the way to Posture 1", hands.words());
  }

  @Test
  void filesKeepPosturesAndSayWhatIsWrong(@TempDir Path folder) throws Exception {
    hands.store();
    Path file = folder.resolve("mine.yaml");
    hands.save(file);
    key(SWT.DEL, SWT.NONE);
    hands.open(file);
    assertEquals(List.of("Posture 1"), names());
    Files.writeString(file, "postures: 5");
    hands.open(file);
    while (display.readAndDispatch()) {
      continue;
    }
    assertTrue(hands.words().startsWith("Not taken, mine.yaml: line 1: a list of postures is expected"), hands.words());
    assertEquals(List.of("Posture 1"), names());
  }
}
