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
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/** The widgets of one setting: its editor, and below it what it is for or what is wrong. Display thread. */
final class SettingRow {
  private static final int NARROWEST = 120;

  private final Composite editor;
  private final Theme theme;
  private final SettingNode node;
  private final SettingValue value;
  private final Runnable changed;
  private final Label note;
  private final Control input;

  SettingRow(Composite editor, Theme theme, SettingNode node, Runnable changed) {
    this.node = node;
    this.value = node.line();
    this.editor = editor;
    this.theme = theme;
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
    return value.isFlag() ? flag() : value.isChoice() ? choice(value.words()) : text();
  }

  void focus() {
    input.setFocus();
    if (input.getDisplay().getFocusControl() instanceof Text text) {
      text.setSelection(text.getCharCount()); // typing goes on where it was
    }
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
    return value.value().map(Object::toString)
        .orElse(value.setting().required() ? value.fallback() : value.fallback() + "  (usual)");
  }

  private void choose(ChoiceField field, List<String> words) {
    PopupMenu menu = new PopupMenu(field.control());
    List<Optional<Object>> choices = new ArrayList<>();
    words.forEach(w -> choices.add(Optional.of(w)));
    choices.forEach(c -> menu.radio(c.map(Object::toString).orElse(""), c.equals(value.value()), () -> take(field, c)));
    if (!value.setting().required()) {
      menu.line();
      menu.push("As usual: " + value.fallback(), () -> take(field, Optional.empty()));
    }
    menu.openBelow(field.control());
  }

  private void take(ChoiceField field, Optional<Object> choice) {
    value.set(choice);
    field.show(shown());
    changed();
  }

  private Control text() {
    Composite line = value.words().isEmpty() ? editor : Boxes.panel(editor, theme, 2);
    Composite well = Well.in(line, theme);
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
    if (line != editor) {
      line.setLayoutData(wide());
      suggestions(line, text);
    }
    return text;
  }

  /** Words that may be meant; any other can be typed. */
  private void suggestions(Composite line, Text text) {
    QuietButton[] button = new QuietButton[1];
    button[0] = new QuietButton(line, theme, () -> {
      PopupMenu menu = new PopupMenu(button[0]);
      value.words().forEach(w -> menu.radio(w, w.equals(text.getText()), () -> text.setText(w)));
      menu.openBelow(button[0]);
    }).icon(Icon.OPEN).hint("Choose " + value.setting().name());
    GridData end = new GridData(SWT.END, SWT.CENTER, false, false);
    end.heightHint = FormCells.ROW;
    button[0].setLayoutData(end);
  }

  private void changed() {
    tell();
    changed.run();
  }

  private void tell() {
    Optional<String> problem = node.problem();
    note.setForeground(theme.color(problem.isPresent() ? Role.BAD : Role.DIM));
    note.setText(problem.orElse(node.isItem() ? "" : HelpText.of(value.setting())).replace("&", "&&"));
    Boxes.seen(note, !note.getText().isEmpty());
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
