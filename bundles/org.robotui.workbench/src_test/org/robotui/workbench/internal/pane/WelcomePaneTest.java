package org.robotui.workbench.internal.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.control.CheckBox;
import org.robotui.ui.control.QuietButton;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class WelcomePaneTest implements WelcomePane.Actions {
  private static final List<Path> RECENT = List.of(Path.of("/robots/keira.yaml"), Path.of("run.mcap"));

  private final Theme theme = Themes.dark(TestDisplay.get());
  private final Shell shell = new Shell(TestDisplay.get());
  private final List<String> begun = new ArrayList<>();

  @BeforeEach
  void prepare() {
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, 900, 800);
    shell.open();
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  private WelcomePane pane(List<Path> recent) {
    WelcomePane pane = new WelcomePane(shell, theme, recent, true, this);
    shell.layout(true, true);
    return pane;
  }

  @Test
  void eachButtonBeginsWhatItSays() {
    List<QuietButton> buttons = buttons(pane(RECENT));
    buttons.forEach(QuietButton::press);
    assertEquals(List.of("demo", "create", "open", "recording", "open /robots/keira.yaml", "open run.mcap", "software",
        "documentation", "tutorial"), begun);
    buttons.forEach(b -> assertTrue(b.getSize().x > 100 && b.getSize().y > 10, "each is seen"));
  }

  @Test
  void nothingIsSaidOfWhatWasOpenedBeforeWhereThatIsNothing() {
    assertEquals(7, buttons(pane(List.of())).size());
  }

  @Test
  void theChoiceWhetherItIsShownIsTold() {
    Control box = parts(pane(RECENT)).filter(c -> c.getSize().x == CheckBox.HEIGHT && c.getSize().y == CheckBox.HEIGHT)
        .findFirst().orElseThrow();
    Event space = new Event();
    space.character = ' ';
    space.keyCode = ' ';
    box.notifyListeners(SWT.KeyDown, space);
    box.notifyListeners(SWT.KeyDown, space);
    assertEquals(List.of("wanted false", "wanted true"), begun);
  }

  @Test
  void overARobotItClosesBeforeSomethingElseOpens() {
    new WelcomeDialog(shell, theme, RECENT, true, this).open();
    Shell dialog = shell.getShells()[0];
    List<QuietButton> buttons = buttons(dialog);
    buttons.getLast().press();
    assertFalse(dialog.isDisposed(), "one reads beside it");
    buttons.getFirst().press();
    assertTrue(dialog.isDisposed());
    assertEquals(List.of("tutorial", "demo"), begun);
  }

  private static List<QuietButton> buttons(Control within) {
    return parts(within).filter(QuietButton.class::isInstance).map(QuietButton.class::cast).toList();
  }

  private static Stream<Control> parts(Control control) {
    return control instanceof Composite c
        ? Stream.concat(Stream.of(c), Arrays.stream(c.getChildren()).flatMap(WelcomePaneTest::parts))
        : Stream.of(control);
  }

  @Override
  public void demo() {
    begun.add("demo");
  }

  @Override
  public void create() {
    begun.add("create");
  }

  @Override
  public void open() {
    begun.add("open");
  }

  @Override
  public void recording() {
    begun.add("recording");
  }

  @Override
  public void open(Path file) {
    begun.add("open " + file);
  }

  @Override
  public void software() {
    begun.add("software");
  }

  @Override
  public void documentation() {
    begun.add("documentation");
  }

  @Override
  public void tutorial() {
    begun.add("tutorial");
  }

  @Override
  public void wanted(boolean wanted) {
    begun.add("wanted " + wanted);
  }
}
