package org.robotui.workbench.internal.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
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
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.ViewKey;
import org.robotui.ui.control.QuietButton;
import org.robotui.workbench.internal.keys.KeyStore;
import org.robotui.workbench.internal.keys.KeyWords;
import org.robotui.workbench.internal.keys.KeyedCommand;
import org.robotui.workbench.internal.keys.KeysFile;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class KeysPaneTest {
  private final Theme theme = Themes.dark(TestDisplay.get());
  private final Shell shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);
  private final List<Boolean> silenced = new ArrayList<>();
  private final KeyRecorder recorder = new KeyRecorder(TestDisplay.get(), silenced::add);
  private @TempDir Path folder;
  private KeyStore store;
  private KeysPane pane;

  @BeforeEach
  void open() {
    store = new KeyStore(new KeysFile(folder.resolve("keys.yaml")), told -> {});
    store.commands(
        List.of(command("stop", "Stop All Robots", true, "F12"), command("lease", "Take Control", false, "Ctrl+L"),
            command("search", "Search", false, "Ctrl+3"), command("reload", "Read Again", false)));
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, 800, 500);
    pane = new KeysPane(shell, theme, store, () -> Map.of("Log", List.of(new ViewKey("Ctrl+F, /", "Find"))), recorder);
    shell.open();
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void aKeyIsRecordedAndHoldsAtOnce() {
    choose("reload");
    press("Gives the command another key");
    type(SWT.CTRL, SWT.CTRL);
    assertEquals(List.of(true), silenced, "modifiers alone are no key");
    type('r', SWT.CTRL | SWT.SHIFT);

    assertEquals(List.of(true, false), silenced);
    assertEquals("Ctrl+Shift+R", store.text("reload"));
    press("Gives the command one more key");
    type(SWT.F5, 0);
    assertEquals("Ctrl+Shift+R, F5", keys("reload"));
    press("Gives the command the keys");
    assertEquals("", keys("reload"));
  }

  @Test
  void aKeyOfAnotherCommandIsTakenOverOnlyWhenAsked() {
    choose("reload");
    press("Gives the command another key");
    type('l', SWT.CTRL);

    assertEquals("Ctrl+L", keys("lease"));
    assertTrue(button("Gives the key to this").isVisible());
    press("Gives the key to this");
    assertEquals("", keys("lease"));
    assertEquals("Ctrl+L", keys("reload"));
    assertFalse(button("Gives the key to this").isVisible());
    press("Gives all commands");
    assertEquals("Ctrl+L", keys("lease"));
  }

  @Test
  void theStopKeepsItsKeyAndNobodyElseGetsIt() {
    choose("stop");
    press("The command has no key");
    press("Gives the command another key");
    assertEquals(List.of(), silenced, "nothing is recorded");
    assertEquals("F12", keys("stop"));

    choose("reload");
    press("Gives the command another key");
    type(SWT.F12, 0);
    assertEquals("", keys("reload"));
    press("Gives the command another key");
    type('r', 0);
    assertEquals("", keys("reload"), "a letter alone");
  }

  @Test
  void escapeLeavesTheKeysAsTheyAre() {
    choose("search");
    press("Gives the command another key");
    type(SWT.ESC, 0);

    assertEquals(List.of(true, false), silenced);
    assertEquals("Ctrl+3", keys("search"));
  }

  private static KeyedCommand command(String id, String name, boolean fixed, String... keys) {
    return new KeyedCommand(id, name, "Robot", "Does it",
        Stream.of(keys).map(k -> KeyWords.read(k).orElseThrow()).toList(),
        fixed);
  }

  private String keys(String id) {
    return KeyWords.text(store.now().keys(store.now().command(id).orElseThrow()));
  }

  private void choose(String id) {
    pane.select(id);
  }

  private void press(String hint) {
    button(hint).press();
  }

  private QuietButton button(String hint) {
    return all(pane).filter(QuietButton.class::isInstance).map(QuietButton.class::cast)
        .filter(b -> String.valueOf(b.getToolTipText()).startsWith(hint)).findFirst().orElseThrow();
  }

  private static Stream<Control> all(Composite parent) {
    return Arrays.stream(parent.getChildren())
        .flatMap(c -> Stream.concat(Stream.of(c), c instanceof Composite inner ? all(inner) : Stream.empty()));
  }

  private void type(int key, int modifiers) {
    Event event = new Event();
    event.type = SWT.KeyDown;
    event.keyCode = key;
    event.character = key < 256 ? (char) key : 0;
    event.stateMask = modifiers;
    pane.notifyListeners(SWT.KeyDown, event);
  }
}
