package org.robotui.uic.plugins.internal.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.config.Schema;
import org.robotui.api.port.PluginReply;
import org.robotui.api.port.PluginRequest;
import org.robotui.api.port.PluginRequest.Verb;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.control.Drives.Phase;
import org.robotui.data.control.Drives;
import org.robotui.data.control.LoopTiming;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeCaller;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.uic.plugins.internal.Controls;
import org.robotui.uic.plugins.internal.model.PluginsModel;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class PluginsSwtTest {
  private final Display display = TestDisplay.get();
  private final FakeUicContext context = new FakeUicContext("plugins", Schema.EMPTY);
  private final FakeInput<ControlPlugins> plugins = new FakeInput<>();
  private final FakeInput<LoopTiming> timing = new FakeInput<>();
  private final FakeInput<Drives> drives = new FakeInput<>();
  private final FakeCaller<PluginRequest, PluginReply> caller = new FakeCaller<>(Controls.VERBS);
  private final PluginsModel model =
      new PluginsModel(context, plugins, timing, drives, caller, () -> Duration.ofSeconds(1));
  private Theme theme;
  private Shell shell;
  private PluginsSurface surface;
  private String note = "";

  @BeforeEach
  void open() {
    theme = Themes.dark(display);
    shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, 1200, 600);
    plugins.put(Controls.arm());
    timing.put(Controls.timing(true));
    model.tick(0);
    surface = new PluginsSurface(shell, UiContext.of(theme, text -> note = text), model);
    shell.open();
    while (display.readAndDispatch()) {
      continue;
    }
    surface.refresh();
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void theFirstThreadIsShownAtOnce() {
    assertEquals("loop HAL/hal", surface.list().selected().getFirst().key());
    assertTrue(note.startsWith("3 of 6 running"), note);
  }

  @Test
  void drivesAreAskedWhatTheirPhasesAllow() {
    drives.put(Controls.drives(Phase.FAULT, Phase.ENABLED, Phase.ENABLED));
    model.tick(0);
    surface.select("drives");
    DetailHead head = surface.detail().head();
    assertTrue(head.recover().getVisible() && head.recover().getEnabled() && head.disable().getEnabled());
    assertFalse(head.enable().getEnabled() || head.start().getVisible());
    head.recover().press();
    assertEquals(new PluginRequest("", Verb.RECOVER_DRIVES, ""), caller.made().getLast().request());
    assertFalse(head.recover().getEnabled(), "one request at a time");
  }

  @Test
  void aClickOnASwitchTurnsIt() {
    press("plugin sine", 20);
    assertEquals(new PluginRequest("sine", Verb.START, ""), caller.made().getLast().request());
    press("plugin homing", 20);
    assertEquals(new PluginRequest("homing", Verb.STOP, ""), caller.made().getLast().request());
  }

  /** One that cannot be switched is left out. */
  @Test
  void severalThatAreSelectedAreSwitchedTogether() {
    surface.list().selectAll(List.of("plugin sine", "plugin homing", "plugin cartesian", "loop HAL/hal"));
    ViewAction together = surface.menu(surface.list().selected()).getFirst();
    assertEquals("Switch 2 together", together.label());
    together.run().run();
    PluginRequest request = caller.made().getLast().request();
    assertEquals(Verb.SWITCH_TOGETHER, request.verb());
    assertTrue(Set.of("sine 1 homing 0", "homing 0 sine 1").contains(request.words()), request.words());
    surface.list().select("plugin sine");
    assertFalse(surface.menu(surface.list().selected()).getFirst().label().contains("together"));
  }

  @Test
  void aClickBesideTheSwitchOnlySelects() {
    press("plugin sine", 120);
    assertTrue(caller.made().isEmpty());
    assertEquals("plugin sine", surface.list().selected().getFirst().key());
  }

  @Test
  void aFailedPluginCannotBeSwitchedButReloaded() {
    press("plugin cartesian", 20);
    assertTrue(caller.made().isEmpty());
    assertFalse(surface.detail().head().start().isEnabled());
    surface.detail().head().reload().press();
    assertEquals(new PluginRequest("cartesian", Verb.RELOAD, ""), caller.made().getLast().request());
  }

  @Test
  void anErrorIsShownWhole() {
    surface.select("plugin cartesian");
    assertEquals(4, surface.detail().problem().getText().lines().count());
    assertTrue(surface.detail().problem().isVisible());
    surface.select("plugin homing");
    assertFalse(surface.detail().problem().isVisible());
  }

  @Test
  void aCommandGoesToTheSelectedPlugin() {
    surface.select("plugin homing");
    surface.detail().command().text().setText("  speed 0.4 ");
    surface.detail().command().text().notifyListeners(SWT.DefaultSelection, new Event());
    assertEquals(new PluginRequest("homing", Verb.COMMAND, "speed 0.4"), caller.made().getLast().request());
    assertEquals("", surface.detail().command().text().getText());
  }

  private void press(String key, int x) {
    Rectangle row = surface.list().bounds(key).orElseThrow();
    Event event = new Event();
    event.button = 1;
    event.x = row.x + x;
    event.y = row.y + row.height / 2;
    surface.list().control().notifyListeners(SWT.MouseDown, event);
  }
}
