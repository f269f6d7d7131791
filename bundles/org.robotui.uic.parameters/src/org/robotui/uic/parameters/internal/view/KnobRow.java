package org.robotui.uic.parameters.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Text;
import org.robotui.api.input.Unreadable;
import org.robotui.api.port.Browser.Choice;
import org.robotui.api.port.Browser.Tunable;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.CheckBox;
import org.robotui.ui.control.ChoiceField;
import org.robotui.ui.control.LimitBar;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;
import org.robotui.uic.parameters.internal.model.Knob;
import org.robotui.uic.parameters.internal.model.Tuner;

/**
 * One setting: its name, what sets it, a way back to the default, and below its help or what is wrong. Display thread.
 */
final class KnobRow {
  private static final int NAME_WIDTH = 150;
  private static final int FIELD_WIDTH = 92;
  private static final int COLUMNS = 4;

  private final Theme theme;
  private final Tuner tuner;
  private final Composite root;
  private final Caption name;
  private final Caption below;
  private final QuietButton restore;
  private Optional<LimitBar> bar = Optional.empty();
  private Optional<Text> field = Optional.empty();
  private Optional<CheckBox> check = Optional.empty();
  private Optional<ChoiceField> choices = Optional.empty();
  private Knob knob;
  private String written = "";

  KnobRow(Composite parent, Theme theme, Tuner tuner, Knob first) {
    this.theme = theme;
    this.tuner = tuner;
    this.knob = first;
    root = Boxes.panel(parent, theme, COLUMNS);
    root.setLayoutData(Boxes.line());
    GridLayout layout = (GridLayout) root.getLayout();
    layout.marginWidth = Theme.EDGE;
    layout.marginTop = Theme.STEP;
    layout.horizontalSpacing = 2 * Theme.STEP;
    name = new Caption(root, theme, Face.BODY);
    name.width(NAME_WIDTH);
    controls(first.tunable());
    restore = new QuietButton(root, theme, () -> tuner.set(knob.tunable().name(), knob.tunable().fallback()))
        .icon(Icon.RESTART);
    restore.setLayoutData(Boxes.middle());
    below = new Caption(root, theme, Face.SMALL);
    below.indent(NAME_WIDTH + 2 * Theme.STEP, COLUMNS);
    show(first);
  }

  Optional<Text> field() {
    return field;
  }

  Optional<LimitBar> bar() {
    return bar;
  }

  Knob knob() {
    return knob;
  }

  void show(Knob next) {
    knob = next;
    Tunable tunable = next.tunable();
    name.show(tunable.name(), next.isDefault() ? Role.TEXT : Role.ACCENT, tunable.help());
    restore.setVisible(!next.isDefault());
    restore.hint("Back to the default, " + KnobText.of(tunable, tunable.fallback()));
    bar.ifPresent(b -> b.value(((Number) next.value()).doubleValue() - KnobText.least(tunable, 0)));
    field.ifPresent(this::write);
    check.ifPresent(c -> c.show(Boolean.TRUE.equals(next.value())));
    choices.ifPresent(c -> c.show(KnobText.of(tunable, next.value())));
    String help =
        KnobText.choice(tunable, next.value()).map(Choice::help).filter(h -> !h.isBlank()).orElse(tunable.help());
    below.show(next.problem().orElse(help), next.problem().isPresent() ? Role.BAD : Role.DIM,
        next.problem().orElse(help));
  }

  private void controls(Tunable tunable) {
    if (!tunable.choices().isEmpty()) {
      choices = Optional.of(new ChoiceField(root, theme, tunable.name(), this::choose));
      choices.get().control().setLayoutData(wide());
    } else if (tunable.value() instanceof Boolean) {
      check = Optional.of(new CheckBox(root, theme, tunable.name(), this::flip));
      check.get().control().setLayoutData(wide());
    } else if (KnobText.isRanged(tunable)) {
      LimitBar slider = new LimitBar(root, theme, KnobText.most(tunable, 1) - KnobText.least(tunable, 0), this::slide);
      slider.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
      slider.setToolTipText(KnobText.range(tunable));
      bar = Optional.of(slider);
      field = Optional.of(text(FIELD_WIDTH, 1));
    } else {
      field = Optional.of(text(SWT.DEFAULT, 2));
    }
  }

  private static GridData wide() {
    GridData data = new GridData(SWT.FILL, SWT.CENTER, true, false);
    data.horizontalSpan = 2;
    data.heightHint = CheckBox.HEIGHT;
    return data;
  }

  private Text text(int width, int span) {
    Text text = new Text(root, SWT.SINGLE);
    text.setFont(theme.font(Face.FIGURES));
    text.setBackground(theme.color(Role.GROUND));
    text.setForeground(theme.color(Role.TEXT));
    GridData data =
        new GridData(width == SWT.DEFAULT ? SWT.FILL : SWT.BEGINNING, SWT.CENTER, width == SWT.DEFAULT, false);
    data.widthHint = width == SWT.DEFAULT ? 0 : width;
    data.horizontalSpan = span;
    text.setLayoutData(data);
    text.addListener(SWT.DefaultSelection, e -> commit(text));
    text.addListener(SWT.FocusOut, e -> commit(text));
    return text;
  }

  /** What the user types is not replaced by what the program says. */
  private void write(Text text) {
    String value = KnobText.of(knob.tunable(), knob.value());
    boolean typing = text.isFocusControl() && !text.getText().equals(written);
    if (!typing && !text.getText().equals(value) && knob.problem().isEmpty()) {
      text.setText(value);
    }
    written = typing ? written : value;
  }

  private void commit(Text text) {
    if (text.getText().equals(written)) {
      return;
    }
    try {
      Object value = KnobText.read(knob.tunable(), text.getText());
      written = text.getText();
      tuner.set(knob.tunable().name(), value);
    } catch (Unreadable e) {
      tuner.wrong(knob.tunable().name(), e.getMessage());
    }
    refresh();
  }

  private void slide(double offset) {
    tuner.set(knob.tunable().name(), KnobText.at(knob.tunable(), offset));
    refresh();
  }

  private void flip() {
    tuner.set(knob.tunable().name(), !Boolean.TRUE.equals(knob.value()));
    refresh();
  }

  private void choose() {
    PopupMenu menu = new PopupMenu(root);
    for (Choice choice : knob.tunable().choices()) {
      String help = choice.help().isBlank() ? "" : "  \u2014  " + choice.help();
      menu.radio(choice.name() + help, choice.value().equals(knob.value()), () -> choose(choice));
    }
    choices.map(ChoiceField::control).ifPresent(menu::openBelow);
  }

  private void choose(Choice choice) {
    if (!choice.value().equals(knob.value())) {
      tuner.set(knob.tunable().name(), choice.value());
      refresh();
    }
  }

  /** Shows at once what was done. */
  private void refresh() {
    tuner.panel().knobs().stream().filter(k -> k.tunable().name().equals(knob.tunable().name())).findFirst()
        .ifPresent(this::show);
  }
}
