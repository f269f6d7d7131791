package org.robotui.workbench.internal.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.SettingsGroup;
import org.robotui.api.host.SettingsGroup.Part;
import org.robotui.api.host.SettingsOutcome;
import org.robotui.testkit.TestDisplay;
import org.robotui.testkit.host.FakeHost;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.control.QuietButton;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class WrittenPaneTest {
  private final Theme theme = Themes.dark(TestDisplay.get());
  private final Shell shell = new Shell(TestDisplay.get());
  private final FakeHost host = new FakeHost();
  private final List<Map<String, Object>> written = new ArrayList<>();
  private String wanted = "";
  private SettingsOutcome outcome = new SettingsOutcome.Done(Path.of("demo.yaml"), List.of("max_linear"));

  @BeforeEach
  void open() {
    host.settable(List.of(safety("Natalie", "0.6"), safety("Keira", "0.5")), (group, values) -> {
      written.add(values);
      return outcome;
    }).checking((setting, value) -> setting.type().fit(Double.valueOf(value.toString())).isPresent() ? Optional.empty()
        : Optional.of("it must be " + setting.type().expected()));
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, 900, 500);
    new WrittenPane(shell, theme, host, Runnable::run, () -> wanted);
    wanted = "Keira"; // as the platform says it after the pane was made
    shell.open();
    events();
  }

  private static SettingsGroup safety(String robot, String value) {
    Schema schema = Schema.of(Setting.optional("max_linear", new ValueType.Num(0, 100, "m/s"), "no command is faster"));
    return new SettingsGroup(Part.SAFETY, robot, robot, robot, "", Path.of("demo.yaml"),
        List.of("ruics", robot, "safety", robot), 26, schema, Map.of("max_linear", value), "1");
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void whatIsChangedIsWrittenAndNothingElse() {
    assertEquals("0.5", field().getText(), "of the robot that was asked for");
    assertFalse(button("Writes what was changed").isEnabled(), "nothing is changed");
    field().setText("0.25");
    assertTrue(button("Writes what was changed").isEnabled());
    press("Writes what was changed");
    assertEquals(List.of(Map.of("max_linear", "0.25")), written);
    assertEquals("0.5", field().getText(), "as the file says now");
  }

  @Test
  void whatIsWrongIsSaidAndNotWritten() {
    field().setText("1000");
    assertFalse(button("Writes what was changed").isEnabled());
    field().setText("0.25");
    outcome = new SettingsOutcome.Refused("demo.yaml was changed meanwhile");
    press("Writes what was changed");
    assertEquals("0.25", field().getText(), "what was typed stays");
    press("Reads the file again");
    assertEquals("0.5", field().getText());
  }

  private Text field() {
    return parts(shell).filter(Text.class::isInstance).map(Text.class::cast)
        .filter(t -> t.getMessage().equals("none")).findFirst().orElseThrow();
  }

  private QuietButton button(String hint) {
    return parts(shell).filter(QuietButton.class::isInstance).map(QuietButton.class::cast)
        .filter(b -> String.valueOf(b.getToolTipText()).startsWith(hint)).findFirst().orElseThrow();
  }

  private void press(String hint) {
    button(hint).press();
    events();
  }

  private static Stream<Control> parts(Control control) {
    return control instanceof Composite c
        ? Stream.concat(Stream.of(c), Arrays.stream(c.getChildren()).flatMap(WrittenPaneTest::parts))
        : Stream.of(control);
  }

  private static void events() {
    while (TestDisplay.get().readAndDispatch()) {
      // all that waits
    }
  }
}
