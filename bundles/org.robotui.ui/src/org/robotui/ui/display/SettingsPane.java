package org.robotui.ui.display;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.ScrolledComposite;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.ChoiceField;
import org.robotui.ui.control.PlainLabel;
import org.robotui.ui.control.PopupMenu;

/** The settings of one of a list, generated from the schema of its kind. Display thread. */
final class SettingsPane {
  private static final int NAME_WIDTH = 96;
  private static final int HEIGHT = 26;
  private static final String AUTOMATIC = "automatic";

  private final Theme theme;
  private final DisplayList list;
  private final Runnable changed;
  private final ScrolledComposite scrolled;
  private final Composite content;
  private final List<Editor> editors = new ArrayList<>();
  private Optional<DisplayRow> shown = Optional.empty();

  /** A control that can show another value than was typed into it. */
  private record Editor(Setting setting, SettingEditor editor) {}

  SettingsPane(Composite parent, Theme theme, DisplayList list, Runnable changed) {
    this.theme = theme;
    this.list = list;
    this.changed = changed;
    scrolled = new ScrolledComposite(parent, SWT.V_SCROLL);
    scrolled.setBackground(theme.color(Role.PANEL));
    scrolled.setExpandHorizontal(true);
    scrolled.setExpandVertical(true);
    scrolled.setShowFocusedControl(true);
    content = Boxes.inset(scrolled, theme, 2, Theme.EDGE, 2 * Theme.STEP);
    ((GridLayout) content.getLayout()).verticalSpacing = Theme.STEP;
    scrolled.setContent(content);
    scrolled.addListener(SWT.Resize, e -> fit());
  }

  Control control() {
    return scrolled;
  }

  boolean shows(String id) {
    return shown.filter(r -> r.spec().id().equals(id)).isPresent();
  }

  void show(DisplayRow row) {
    boolean same = shown.filter(r -> structure(r).equals(structure(row))).isPresent();
    shown = Optional.of(row);
    if (!same) {
      build(row);
    }
    row.settings().ifPresent(
        s -> editors.forEach(e -> Optional.ofNullable(s.values().get(e.setting().name())).ifPresent(e.editor()::show)));
  }

  /** What the controls are made for; values may change without making them anew. */
  private static List<Object> structure(DisplayRow row) {
    return List.of(row.spec().id(), row.name(), row.spec().sources(), row.choices(),
        row.settings().map(Settings::schema));
  }

  private void build(DisplayRow row) {
    for (Control old : content.getChildren()) {
      old.dispose();
    }
    editors.clear();
    PlainLabel title = new PlainLabel(content, SWT.NONE, theme, Face.BODY_STRONG, Role.TEXT);
    title.setText(row.name().replace("&", "&&"));
    GridData wide = new GridData(SWT.FILL, SWT.CENTER, true, false, 2, 1);
    wide.widthHint = NAME_WIDTH;
    title.setLayoutData(wide);
    if (!row.choices().isEmpty() || !row.spec().sources().isEmpty()) {
      source(row);
    }
    row.settings().ifPresent(
        s -> s.schema().settings().stream().filter(SettingsPane::editable).forEach(setting -> setting(row, setting)));
    fit();
  }

  private static boolean editable(Setting setting) {
    return !(setting.type() instanceof ValueType.Section || setting.type() instanceof ValueType.MapOf);
  }

  private void source(DisplayRow row) {
    label("source", "Where its data come from");
    ChoiceField[] field = new ChoiceField[1];
    field[0] = new ChoiceField(content, theme, "source", () -> choose(row, field[0].control()));
    field[0].show(row.spec().sources().isEmpty() ? AUTOMATIC : String.join(", ", row.spec().sources()));
    field[0].control().setLayoutData(Boxes.line(HEIGHT));
  }

  private void choose(DisplayRow row, Control field) {
    String id = row.spec().id();
    PopupMenu menu = new PopupMenu(field, changed);
    menu.radio(AUTOMATIC, row.spec().sources().isEmpty(), () -> list.change(id, s -> s.from(List.of())));
    row.choices()
        .forEach(c -> menu.radio(c, row.spec().sources().contains(c), () -> list.change(id, s -> s.from(List.of(c)))));
    menu.openBelow(field);
  }

  private void setting(DisplayRow row, Setting setting) {
    label(setting.name().replace('_', ' '), setting.help());
    String id = row.spec().id();
    SettingEditor editor = SettingEditor.of(content, theme, setting, value -> {
      list.set(id, setting.name(), value);
      changed.run();
    });
    editor.control().setLayoutData(Boxes.line(HEIGHT));
    editors.add(new Editor(setting, editor));
  }

  private void label(String name, String help) {
    PlainLabel label = new PlainLabel(content, SWT.NONE, theme, Face.SMALL, Role.DIM);
    label.setText(name.replace("&", "&&"));
    label.setToolTipText(help.replace("&", "&&"));
    GridData data = new GridData(SWT.FILL, SWT.CENTER, false, false);
    data.widthHint = NAME_WIDTH;
    label.setLayoutData(data);
  }

  private void fit() {
    int width = scrolled.getClientArea().width;
    scrolled.setMinSize(content.computeSize(Math.max(1, width), SWT.DEFAULT));
    content.layout(true, true);
  }
}
