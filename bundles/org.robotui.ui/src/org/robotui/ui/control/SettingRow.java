package org.robotui.ui.control;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Label;
import org.eclipse.swt.widgets.Text;
import org.robotui.api.config.ValueType;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/** The widgets of one setting: its editor, and below it what it is for or what is wrong. Display thread. */
final class SettingRow {
  private static final int NARROWEST = 120;

  private final Composite editor;
  private final Theme theme;
  private final SettingValue value;
  private final Runnable changed;
  private final Label note;
  private final Control input;

  SettingRow(Composite editor, Theme theme, SettingValue value, Runnable changed) {
    this.editor = editor;
    this.theme = theme;
    this.value = value;
    this.changed = changed;
    GridLayout layout = new GridLayout(1, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.verticalSpacing = 1;
    editor.setLayout(layout);
    input = input();
    note = new PlainLabel(editor, SWT.WRAP, theme, Face.SMALL, Role.DIM);
    note.setLayoutData(wide());
    tell();
  }

  private Control input() {
    if (!value.canBeTyped()) {
      Label only = new PlainLabel(editor, SWT.NONE, theme, Face.BODY, Role.DIM);
      only.setText(value.value().isPresent() ? "as written in the file" : "can only be written in the file");
      GridData beside = wide();
      beside.verticalIndent = Theme.STEP;
      only.setLayoutData(beside);
      return only;
    }
    return switch (value.setting().type()) {
      case ValueType.Flag f -> flag();
      case ValueType.Choice c -> choice(c.words());
      default -> text();
    };
  }

  void focus() {
    input.setFocus();
  }

  private Control flag() {
    CheckBox[] box = new CheckBox[1];
    box[0] = new CheckBox(editor, theme, value.setting().name(), () -> {
      value.set(Optional.of(!isOn()));
      box[0].show(isOn());
      changed();
    });
    box[0].show(isOn());
    box[0].control().setLayoutData(high());
    return box[0].control();
  }

  private boolean isOn() {
    return value.value().or(() -> value.setting().fallback()).filter(Boolean.TRUE::equals).isPresent();
  }

  private Control choice(List<String> words) {
    ChoiceField[] field = new ChoiceField[1];
    field[0] = new ChoiceField(editor, theme, value.setting().name(), () -> choose(field[0], words));
    field[0].show(shown());
    field[0].control().setLayoutData(high());
    return field[0].control();
  }

  private String shown() {
    return value.value().map(Object::toString).orElse(value.fallback() + "  (usual)");
  }

  private void choose(ChoiceField field, List<String> words) {
    PopupMenu menu = new PopupMenu(field.control());
    List<Optional<Object>> choices = new ArrayList<>();
    words.forEach(w -> choices.add(Optional.of(w)));
    choices.forEach(c -> menu.radio(c.map(Object::toString).orElse(""), c.equals(value.value()), () -> take(field, c)));
    menu.line();
    menu.push("As usual: " + value.fallback(), () -> take(field, Optional.empty()));
    menu.openBelow(field.control());
  }

  private void take(ChoiceField field, Optional<Object> choice) {
    value.set(choice);
    field.show(shown());
    changed();
  }

  private Control text() {
    Composite well = Well.in(editor, theme);
    well.setLayoutData(high());
    Text text = new Text(well, SWT.SINGLE);
    text.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, true));
    text.setText(value.text());
    text.setMessage(value.fallback());
    text.setFont(theme.font(Face.BODY));
    text.setBackground(theme.color(Role.GROUND));
    text.setForeground(theme.color(Role.TEXT));
    Spoken.name(text, value.setting().name());
    text.addListener(SWT.Modify, e -> {
      value.type(text.getText());
      changed();
    });
    return text;
  }

  private void changed() {
    tell();
    changed.run();
  }

  private void tell() {
    Optional<String> problem = value.problem();
    note.setForeground(theme.color(problem.isPresent() ? Role.BAD : Role.DIM));
    note.setText(problem.orElse(value.setting().help()).replace("&", "&&"));
    editor.requestLayout();
  }

  private static GridData wide() {
    GridData data = new GridData(SWT.FILL, SWT.CENTER, true, false);
    data.widthHint = NARROWEST;
    return data;
  }

  private static GridData high() {
    GridData data = wide();
    data.heightHint = FormCells.ROW;
    return data;
  }
}
