package org.robotui.ui.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.SettingsForm;

/** The settings of a layer have the fields of its kind. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class LayerFormSwtTest {
  private static final ValueType METRES = new ValueType.Num(0, 10, "m");
  private static final List<DisplayKind> KINDS = List.of(
      kind("scan", Setting.of("size", METRES, 0.5, "Of the dots."), Setting.of("fan", new ValueType.Flag(), false, "")),
      kind("path", Setting.of("size", METRES, 0.1, "Of the line."), Setting.of("ends", METRES, 1.0, "Of its ends.")));
  private static final Map<String, Object> SCAN = Map.of("type", "scan", "settings", Map.of("size", "2", "fan", true));

  private final Theme theme = Themes.dark(TestDisplay.get());
  private final Shell shell = new Shell(TestDisplay.get());
  private SettingsForm form;

  private static DisplayKind kind(String id, Setting... settings) {
    return new DisplayKind(id, id, List.of(), Set.of(), true, Schema.of(settings));
  }

  @BeforeEach
  void open() {
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, 700, 900);
    form = new SettingsForm(shell, theme, (setting, value) -> Optional.empty());
    form.show(Schema.of(Setting.of("layers", DisplayEntry.list("layer", "scan", KINDS), List.of(), "")),
        Map.of("layers", List.of(SCAN)));
    shell.open();
    unfold("1");
    unfold("settings");
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void theFieldsAreThoseOfTheKindAndFollowIt() {
    assertEquals(Map.of("layers", List.of(SCAN)), form.values());
    field("0.5").setText("3");
    field("needed").setText("pat");
    assertEquals(Map.of("type", "pat", "settings", Map.of("size", "3", "fan", true)), layer(), "no kind yet");

    field("needed").setText("path");
    events();
    assertEquals(Map.of("type", "path", "settings", Map.of("size", "3")), layer(), "what both kinds have is kept");
    assertEquals("3", field("0.1").getText());
    field("1.0").setText("4");
    assertEquals(Map.of("type", "path", "settings", Map.of("size", "3", "ends", "4")), layer());
  }

  @Test
  void settingsOfAKindThatIsNotInstalledAreNamesWithValues() {
    ValueType.Section layer = assertInstanceOf(ValueType.Section.class,
        ((ValueType.ListOf) DisplayEntry.list("layer", "scan", KINDS)).element());
    ValueType.Dependent settings =
        assertInstanceOf(ValueType.Dependent.class, layer.schema().find("settings").orElseThrow().type());
    assertInstanceOf(ValueType.MapOf.class, settings.in(Map.of("type", "other")));
    assertEquals(new ValueType.Section(KINDS.getFirst().schema()), settings.in(Map.of("type", "scan")));
  }

  private Object layer() {
    return ((List<?>) form.values().get("layers")).getFirst();
  }

  /** By what holds where nothing is typed. */
  private Text field(String usual) {
    return parts(shell).filter(Text.class::isInstance).map(Text.class::cast)
        .filter(t -> t.getMessage().equals(usual) || t.getMessage().startsWith(usual + " ")).findFirst().orElseThrow();
  }

  private void unfold(String head) {
    parts(shell).filter(QuietButton.class::isInstance).map(QuietButton.class::cast)
        .filter(b -> ("Open " + head).equals(b.getToolTipText())).findFirst().orElseThrow().press();
    events();
  }

  private static Stream<Control> parts(Control control) {
    return control instanceof Composite c
        ? Stream.concat(Stream.of(c), Arrays.stream(c.getChildren()).flatMap(LayerFormSwtTest::parts))
        : Stream.of(control);
  }

  private static void events() {
    while (TestDisplay.get().readAndDispatch()) {
      // all that waits
    }
  }
}
