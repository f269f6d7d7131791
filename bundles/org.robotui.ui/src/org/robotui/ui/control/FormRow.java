package org.robotui.ui.control;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Label;
import org.eclipse.swt.widgets.Text;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.RecordShape;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewAction;

/** The widgets of a field that is typed in one line. Display thread. */
final class FormRow {
  private static final int NARROWEST = 60;

  private final Theme theme;
  private final FormLeaf leaf;
  private final Runnable changed;
  private final Composite editor;
  private final Label problem;
  private final Control input;

  FormRow(Composite editor, Theme theme, FormLeaf leaf, Runnable changed) {
    this.theme = theme;
    this.leaf = leaf;
    this.changed = changed;
    this.editor = editor;
    editor.setLayout(layout(leaf.choices().isEmpty() ? 1 : 2));
    input = leaf.shape() instanceof FieldShape.Flag ? flag() : text();
    if (!leaf.choices().isEmpty()) {
      choices();
    }
    problem = problem();
    tell();
  }

  FormLeaf leaf() {
    return leaf;
  }

  Control input() {
    return input;
  }

  private Control flag() {
    CheckBox[] box = new CheckBox[1];
    box[0] = new CheckBox(editor, theme, leaf.path(), () -> flip(box[0]));
    box[0].control().setLayoutData(high(wide()));
    box[0].show(Boolean.parseBoolean(leaf.text()));
    return box[0].control();
  }

  private void flip(CheckBox box) {
    boolean on = !Boolean.parseBoolean(leaf.text());
    leaf.text(Boolean.toString(on));
    box.show(on);
    changed();
  }

  private Control text() {
    Composite well = Well.in(editor, theme);
    well.setLayoutData(high(wide()));
    Text text = new Text(well, SWT.SINGLE);
    text.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, true));
    text.setText(leaf.text());
    text.setMessage(FormInput.placeholder(leaf.shape()));
    text.setFont(theme.font(leaf.shape() instanceof FieldShape.Text ? Face.BODY : Face.FIGURES));
    text.setBackground(theme.color(Role.GROUND));
    text.setForeground(theme.color(Role.TEXT));
    Spoken.name(text, leaf.path());
    text.addListener(SWT.Modify, e -> typed(text.getText()));
    return text;
  }

  private void typed(String words) {
    leaf.text(words);
    changed();
  }

  private void changed() {
    tell();
    changed.run();
  }

  private Label problem() {
    Label label = new PlainLabel(editor, SWT.WRAP, theme, Face.SMALL, Role.BAD);
    GridData data = wide();
    data.horizontalSpan = leaf.choices().isEmpty() ? 1 : 2;
    data.exclude = true;
    label.setLayoutData(data);
    label.setVisible(false);
    return label;
  }

  private void tell() {
    Optional<String> sentence = leaf.problem();
    GridData data = (GridData) problem.getLayoutData();
    problem.setText(sentence.map(words -> leaf.name() + ' ' + words).orElse(""));
    if (data.exclude == sentence.isPresent()) {
      data.exclude = sentence.isEmpty();
      problem.setVisible(sentence.isPresent());
      editor.requestLayout();
    }
  }

  private void choices() {
    QuietButton[] button = new QuietButton[1];
    button[0] =
        new QuietButton(editor, theme, () -> choose(button[0])).icon(Icon.MORE).hint("Named values of " + leaf.path());
    button[0].setLayoutData(high(new GridData(SWT.END, SWT.CENTER, false, false)));
  }

  private void choose(Control button) {
    Point below = button.toDisplay(0, button.getSize().y);
    RowExport.menu(button, below.x, below.y, leaf.choices().stream().map(this::choice).toList());
  }

  private ViewAction choice(RecordShape.Constant constant) {
    String label = constant.name() + " = " + constant.value();
    return new ViewAction(constant.name(), label, "", Optional.empty(), () -> ((Text) input).setText(constant.name()));
  }

  private static GridData wide() {
    GridData data = new GridData(SWT.FILL, SWT.CENTER, true, false);
    data.widthHint = NARROWEST;
    return data;
  }

  private static GridData high(GridData data) {
    data.heightHint = FormCells.ROW;
    return data;
  }

  private static GridLayout layout(int columns) {
    GridLayout layout = new GridLayout(columns, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.horizontalSpacing = Theme.STEP;
    layout.verticalSpacing = 2;
    return layout;
  }
}
