package org.robotui.workbench.internal.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.api.command.Principal;
import org.robotui.api.host.RuicState;
import org.robotui.testkit.Controls;
import org.robotui.testkit.TestDisplay;
import org.robotui.testkit.host.FakeRuic;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.control.QuietButton;
import org.robotui.workbench.internal.model.Lease;
import org.robotui.workbench.internal.model.RecordWords;
import org.robotui.workbench.internal.model.Stops;
import org.robotui.workbench.internal.model.WindowPlaces;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class TopBarTest {
  private static final Principal YOU = new Principal("w", "You", Principal.Kind.WINDOW);
  private static final Stops TWO = new Stops(List.of("Keira", "Natalie"), List.of("Keira", "Natalie"));

  private final NoActions actions = new NoActions();
  private final FakeRuic ruic = new FakeRuic("Keira").in(RuicState.SELECTED, "");
  private final Theme theme = Themes.dark(TestDisplay.get());
  private final Shell shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void theStopIsSeenWholeInNarrowWindowsToo() {
    TopBar bar = new TopBar(shell, theme, Menus.ALL, actions);
    for (int width : new int[]{1600, WindowPlaces.LEAST_WIDTH, 954, 780, 1200, WindowPlaces.LEAST_WIDTH}) {
      bar.setSize(width, 44);
      QuietButton stop = button(bar, "Stop all robots");
      assertTrue(stop.getLocation().x + stop.getSize().x <= width, () -> width + " pixels: " + stop.getBounds());
      assertTrue(stop.getSize().x > 100);
    }
    bar.setSize(820, 44);
    bar.show(Lease.of(ruic.authorities(), ruic.snapshot().link(), YOU), TWO);
    QuietButton release = button(bar, "Release the stop");
    assertTrue(release.getSize().x > 80
        && release.getLocation().x + release.getSize().x <= button(bar, "Stop all robots").getLocation().x);
  }

  @Test
  void whatIsRecordedIsSeenAndGivesWayToTheStop() {
    TopBar bar = new TopBar(shell, theme, Menus.ALL, actions);
    bar.setSize(1600, 44);
    RecordLamp lamp = Controls.all(bar, RecordLamp.class).getFirst();
    bar.recording(Optional.of(new RecordWords(true, "0:12   4.6 MB", "Recording to run.mcap")));

    assertEquals("Recording to run.mcap", lamp.getToolTipText());
    assertTrue(lamp.getSize().x > 100);
    Event pressed = new Event();
    pressed.button = 1;
    lamp.notifyListeners(SWT.MouseDown, pressed);
    assertEquals(List.of("record"), actions.calls);

    bar.setSize(WindowPlaces.LEAST_WIDTH, 44);
    assertTrue(lamp.getSize().x >= 28, () -> lamp.getBounds().toString());
    bar.recording(Optional.empty());
    assertFalse(lamp.getVisible());
  }

  static QuietButton button(Composite parent, String hint) {
    return Arrays.stream(parent.getChildren()).filter(QuietButton.class::isInstance).map(QuietButton.class::cast)
        .filter(b -> String.valueOf(b.getToolTipText()).startsWith(hint)).findFirst().orElseThrow();
  }
}
