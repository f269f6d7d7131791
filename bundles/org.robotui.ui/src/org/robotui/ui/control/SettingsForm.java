package org.robotui.ui.control;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.ScrolledComposite;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Label;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * A form made from what a component can be configured with. What is left blank is left to the component, which is shown
 * in pale; what is wrong is said below the field while it is typed. Display thread only.
 */
public final class SettingsForm {
  private final ScrolledComposite scrolled;
  private final Composite content;
  private final Theme theme;
  private final BiFunction<Setting, Object, Optional<String>> check;
  private final Map<String, SettingRow> rows = new LinkedHashMap<>();
  private final List<SettingValue> settings = new ArrayList<>();
  private Map<String, Object> other = Map.of();
  private Runnable changed = () -> {};

  /**
   * A form without fields.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param check says what is wrong with a value of a setting, or nothing
   */
  public SettingsForm(Composite parent, Theme theme, BiFunction<Setting, Object, Optional<String>> check) {
    this.theme = theme;
    this.check = check;
    scrolled = new ScrolledComposite(parent, SWT.V_SCROLL);
    scrolled.setBackground(theme.color(Role.PANEL));
    scrolled.setExpandHorizontal(true);
    scrolled.setExpandVertical(true);
    scrolled.setShowFocusedControl(true);
    content = new Composite(scrolled, SWT.NONE);
    content.setBackground(theme.color(Role.PANEL));
    scrolled.setContent(content);
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
    scrolled.setRedraw(false);
    rows.clear();
    settings.clear();
    for (Control child : content.getChildren()) {
      child.dispose();
    }
    other = values;
    FormCells cells = new FormCells(content, theme);
    schema.settings().forEach(s -> row(cells, s));
    scrolled.setRedraw(true);
    fit();
  }

  private void row(FormCells cells, Setting setting) {
    SettingValue value = new SettingValue(setting, Optional.ofNullable(other.get(setting.name())), check);
    settings.add(value);
    Label name = cells.name(0, setting.name());
    name.setToolTipText(setting.help().replace("&", "&&"));
    ((GridData) name.getLayoutData()).horizontalIndent = Theme.STEP; // nothing here opens or closes
    Composite editor = cells.part(content);
    rows.put(setting.name(), new SettingRow(editor, theme, value, this::edited));
  }

  /**
   * What is given: Boolean, String, List or Map by name, in the order of the schema.
   *
   * @return what is blank is absent; also what is wrong is there, as typed
   */
  public Map<String, Object> values() {
    Map<String, Object> values = new LinkedHashMap<>();
    settings.forEach(s -> s.value().ifPresent(v -> values.put(s.setting().name(), v)));
    return values;
  }

  /**
   * What is wrong.
   *
   * @return in the order of the fields
   */
  public List<FormProblem> problems() {
    List<FormProblem> problems = new ArrayList<>();
    settings.forEach(s -> s.problem().ifPresent(p -> problems.add(new FormProblem(s.setting().name(), p))));
    return problems;
  }

  /** Puts the cursor into the first field that is wrong. */
  public void showProblem() {
    problems().stream().findFirst().map(p -> rows.get(p.path())).ifPresent(SettingRow::focus);
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
