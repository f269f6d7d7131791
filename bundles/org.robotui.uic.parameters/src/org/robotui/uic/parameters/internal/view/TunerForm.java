package org.robotui.uic.parameters.internal.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.ScrolledComposite;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.port.Browser.Tunable;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.PlainLabel;
import org.robotui.uic.parameters.internal.model.Knob;
import org.robotui.uic.parameters.internal.model.Panel;
import org.robotui.uic.parameters.internal.model.Tuner;

/**
 * The form of a program's settings. It is made again only where the settings are others, not where their values are.
 * Display thread.
 */
final class TunerForm {
  private final Theme theme;
  private final ScrolledComposite scrolled;
  private final List<KnobRow> rows = new ArrayList<>();
  private Object made = List.of();

  TunerForm(Composite parent, Theme theme) {
    this.theme = theme;
    scrolled = new ScrolledComposite(parent, SWT.V_SCROLL);
    scrolled.setBackground(theme.color(Role.PANEL));
    scrolled.setExpandHorizontal(true);
    scrolled.setExpandVertical(true);
    scrolled.setShowFocusedControl(true);
    scrolled.getVerticalBar().setIncrement(3 * Theme.EDGE);
    scrolled.addListener(SWT.Resize, e -> fit());
  }

  Control control() {
    return scrolled;
  }

  List<KnobRow> rows() {
    return rows;
  }

  void show(Tuner tuner, Panel panel) {
    Object wanted = List.of(tuner, panel.knobs().stream().map(knob -> form(knob.tunable())).toList());
    if (!made.equals(wanted)) {
      made = wanted;
      build(tuner, panel.knobs());
    } else {
      for (int i = 0; i < rows.size(); i++) {
        rows.get(i).show(panel.knobs().get(i));
      }
    }
  }

  /** All of a setting but its value. */
  private static Object form(Tunable t) {
    return List.of(t.name(), t.group(), t.help(), t.value().getClass(), t.fallback(), t.least(), t.most(), t.choices());
  }

  private void build(Tuner tuner, List<Knob> knobs) {
    rows.clear();
    if (scrolled.getContent() != null) {
      scrolled.getContent().dispose();
    }
    Composite content = Boxes.panel(scrolled, theme, 1);
    String group = "";
    for (Knob knob : knobs) {
      if (!knob.tunable().group().equals(group)) {
        group = knob.tunable().group();
        heading(content, group);
      }
      rows.add(new KnobRow(content, theme, tuner, knob));
    }
    scrolled.setContent(content);
    fit();
  }

  private void heading(Composite parent, String group) {
    Composite space = Boxes.bar(parent, theme, 1);
    ((GridLayout) space.getLayout()).marginWidth = Theme.EDGE;
    PlainLabel label = new PlainLabel(space, SWT.NONE, theme, Face.SMALL_STRONG, Role.DIM);
    label.setText(group.replace("/", " \u203a ").replace("&", "&&").toUpperCase(Locale.ROOT));
  }

  private void fit() {
    if (scrolled.getContent() instanceof Composite content) {
      scrolled.setMinSize(content.computeSize(Math.max(1, scrolled.getClientArea().width), SWT.DEFAULT));
      content.layout(true, true);
    }
  }
}
