package org.robotui.uic.connections.internal.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.dnd.Clipboard;
import org.eclipse.swt.dnd.TextTransfer;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.port.SourceId;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.uic.connections.internal.model.ConnectionLine;
import org.robotui.uic.connections.internal.model.ConnectionsModel;
import org.robotui.uic.connections.internal.model.Filter;
import org.robotui.uic.connections.internal.model.Robots;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class ConnectionsSwtTest {
  private final ConnectionsModel model = new ConnectionsModel();
  private final List<String> decided = new ArrayList<>();
  private Shell shell;
  private Theme theme;
  private String note = "";
  private ConnectionsSurface surface;

  @BeforeEach
  void open() {
    shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);
    theme = Themes.of(TestDisplay.get(), "dark");
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, 900, 600);
    surface =
        new ConnectionsSurface(shell, UiContext.of(theme, text -> note = text), new Wishes(), ruic -> Optional.empty());
    shell.open();
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void listsAllAndSumsUp() {
    tick(Robots.keira());
    assertEquals(15, surface.list().rows().size());
    assertEquals("1 link: 1 connected; 1 port needs a decision; 1 view port is not connected", note);
  }

  @Test
  void aDecisionIsMadeByKeysAlone() {
    tick(Robots.keira());
    surface.select("Keira\nSTREAM camera.image");
    key(surface.list().control(), SWT.CR);
    Control chooser = TestDisplay.get().getFocusControl();
    assertFalse(chooser == surface.list().control(), "Enter goes to the candidates");
    key(chooser, SWT.ARROW_DOWN);
    key(chooser, SWT.CR);
    assertEquals(List.of("Keira camera.image base./rear/image"), decided);
    key(chooser, SWT.ESC);
    assertTrue(surface.list().control().isFocusControl(), "Esc goes back");
  }

  @Test
  void inALowViewTheCandidatesComeWhenThereIsSomethingToDecide() {
    shell.setSize(900, 240);
    tick(Robots.keira());
    int whole = surface.list().control().getSize().y;
    surface.select("Keira\nSTREAM camera.image");
    assertTrue(surface.list().control().getSize().y < whole);
    key(surface.list().control(), SWT.CR);
    key(TestDisplay.get().getFocusControl(), SWT.CR);
    assertEquals(List.of("Keira camera.image base./front/image"), decided);
    surface.select("Keira\nbase");
    assertEquals(whole, surface.list().control().getSize().y);
  }

  @Test
  void theFocusOfThePartGoesToTheList() {
    surface.control().setFocus();
    assertTrue(surface.list().control().isFocusControl());
  }

  @Test
  void arrowKeysFoldAndUnfold() {
    tick(Robots.keira());
    surface.select("Keira\nbase");
    key(surface.list().control(), SWT.ARROW_LEFT);
    assertEquals(9, surface.list().rows().size());
    key(surface.list().control(), SWT.ARROW_LEFT);
    assertEquals(9, surface.list().rows().size(), "what is folded stays so");
    key(surface.list().control(), SWT.ARROW_RIGHT);
    assertEquals(15, surface.list().rows().size());
    key(surface.list().control(), SWT.CR);
    assertEquals(9, surface.list().rows().size());
  }

  @Test
  void typingFilters() {
    tick(Robots.keira());
    surface.filterField().words("cmd_vel");
    assertEquals(List.of("Keira", "teleop", "cmd_vel \u00b7 Image"),
        surface.list().rows().stream().map(ConnectionLine::name).toList());
    surface.filterField().words("");
    assertEquals(15, surface.list().rows().size());
  }

  @Test
  void theListIsCopiedAsText() {
    tick(Robots.plain("Keira", Robots.DOWN));
    surface.copy();
    Clipboard clipboard = new Clipboard(shell.getDisplay());
    String text = (String) clipboard.getContents(TextTransfer.getInstance());
    clipboard.dispose();
    assertTrue(text.startsWith("1 link: 1 failed\n  retry 4 s    Keira: 1 problem\n  ! retry 4 s"), text);
  }

  @Test
  void fiftyRobotsWithFiftyPortsEachAreShownWithoutAPause() {
    RuicSnapshot[] many =
        IntStream.range(0, 50).mapToObj(i -> Robots.large("robot" + i, 50)).toArray(RuicSnapshot[]::new);
    long best = Long.MAX_VALUE;
    for (int i = 0; i < 5; i++) {
      model.tick(List.of(many), List.of(), i);
      long start = System.nanoTime();
      surface.show(model.shown());
      surface.control().update();
      best = Math.min(best, System.nanoTime() - start);
    }
    assertEquals(5_600, surface.list().rows().size());
    assertTrue(best < 16_000_000, "took " + best / 1_000 + " \u00b5s");
  }

  private void tick(RuicSnapshot... robots) {
    model.tick(List.of(robots), List.of(), 0);
    surface.show(model.shown());
  }

  private static void key(Control control, int code) {
    Event event = new Event();
    event.keyCode = code;
    control.notifyListeners(SWT.KeyDown, event);
  }

  /** Fulfils wishes at once. */
  private final class Wishes implements ConnectionsSurface.Wishes {
    @Override
    public void search(String words) {
      model.filter(Filter.of(false, "", words));
      surface.show(model.shown());
    }

    @Override
    public void problems(boolean only) {
      model.filter(Filter.of(only, "", ""));
      surface.show(model.shown());
    }

    @Override
    public void robot(String name) {
      model.filter(Filter.of(false, name, ""));
      surface.show(model.shown());
    }

    @Override
    public void fold(String key, boolean shut) {
      model.fold(key, shut);
      surface.show(model.shown());
    }

    @Override
    public void connect(String ruic, SourceId port, SourceId peer) {
      decided.add(ruic + " " + port + " " + peer);
    }
  }
}
