package org.robotui.ui.control;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.ScrolledComposite;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * A form made from what a component can be configured with, with groups, lists and names with values, whose items can
 * be added, renamed, moved and removed. What is left blank is left to the component, which is shown in pale; what is
 * wrong is said below the field while it is typed. Display thread only.
 */
public final class SettingsForm {
  private final ScrolledComposite scrolled;
  private final Composite content;
  private final BiFunction<Setting, Object, Optional<String>> check;
  private final SettingsBody body;
  private List<SettingNode> settings = List.of();
  private Runnable changed = () -> {};

  /**
   * A form without fields.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param check says what is wrong with a value of a setting, or nothing
   */
  public SettingsForm(Composite parent, Theme theme, BiFunction<Setting, Object, Optional<String>> check) {
    this.check = check;
    scrolled = new ScrolledComposite(parent, SWT.V_SCROLL);
    scrolled.setBackground(theme.color(Role.PANEL));
    scrolled.setExpandHorizontal(true);
    scrolled.setExpandVertical(true);
    scrolled.setShowFocusedControl(true);
    content = new Composite(scrolled, SWT.NONE);
    content.setBackground(theme.color(Role.PANEL));
    scrolled.setContent(content);
    body = new SettingsBody(content, theme, this::edited);
    scrolled.addListener(SWT.Resize, e -> fit());
  }

  /**
   * What stands in the layout.
   *
   * @return the control
   */
  public Control control() {
    return scrolled;
  }

  /**
   * Shows the fields of another component.
   *
   * @param schema what it can be configured with
   * @param values what is given already; those that are not in the schema are left out
   */
  public void show(Schema schema, Map<String, Object> values) {
    settings =
        schema.settings().stream().map(s -> SettingNode.of(s, Optional.ofNullable(values.get(s.name())), check))
            .toList();
    scrolled.setRedraw(false);
    body.show(settings);
    scrolled.setRedraw(true);
    scrolled.setOrigin(0, 0);
    fit();
  }

  /**
   * What is given: Boolean, String, List or Map by name, in the order of the schema; a number where texts are possible
   * as well.
   *
   * @return what is blank is absent; also what is wrong is there, as typed
   */
  public Map<String, Object> values() {
    Map<String, Object> values = new LinkedHashMap<>();
    settings.forEach(s -> s.value().ifPresent(v -> values.put(s.name(), v)));
    return values;
  }

  /**
   * What is wrong.
   *
   * @return in the order of the fields
   */
  public List<FormProblem> problems() {
    return settings.stream().flatMap(s -> s.problems(s.name()).stream()).toList();
  }

  /** Puts the cursor into the first field that is wrong. */
  public void showProblem() {
    wrong(settings).ifPresent(body::focus);
  }

  private static Optional<SettingNode> wrong(List<SettingNode> nodes) {
    for (SettingNode node : nodes) {
      if (!node.problems("").isEmpty()) {
        return wrong(node.nodes()).or(() -> Optional.of(node));
      }
    }
    return Optional.empty();
  }

  /**
   * Tells when anything was typed or chosen.
   *
   * @param action runs after it
   * @return this
   */
  public SettingsForm onChange(Runnable action) {
    changed = action;
    return this;
  }

  private void edited() {
    fit();
    changed.run();
  }

  private void fit() {
    int width = scrolled.getClientArea().width;
    scrolled.setMinSize(content.computeSize(Math.max(1, width), SWT.DEFAULT));
    content.layout(true, true);
  }
}
