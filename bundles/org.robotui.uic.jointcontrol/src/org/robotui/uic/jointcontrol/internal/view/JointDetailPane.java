package org.robotui.uic.jointcontrol.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.data.joint.JointMode;
import org.robotui.ui.Face;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.uic.jointcontrol.internal.model.Aim;
import org.robotui.uic.jointcontrol.internal.model.JointDetail;
import org.robotui.uic.jointcontrol.internal.model.JointDriver;
import org.robotui.uic.jointcontrol.internal.model.JointRow;

/** All of the selected joint, and the fields for its stiffness and damping where its mode has them. Display thread. */
final class JointDetailPane {
  private static final int COLUMNS = 3;
  private static final int HEIGHT = 62;
  private static final int LINE = 18;
  private static final int LABEL = 84;
  private static final int BELOW = 44;
  private static final int ROOM_BESIDE = 560;

  private final Theme theme;
  private final Composite rule;
  private final Composite root;
  private final PaintedCanvas figures;
  private final GainField stiffness;
  private final GainField damping;
  private Optional<JointRow> shown = Optional.empty();
  private boolean fresh;

  JointDetailPane(Composite parent, Theme theme, JointDriver driver) {
    this.theme = theme;
    rule = Boxes.rule(parent, theme);
    root = Boxes.inset(parent, theme, COLUMNS, Theme.EDGE, Theme.STEP);
    root.setLayoutData(Boxes.line(HEIGHT + 2 * Theme.STEP));
    figures = new PaintedCanvas(root, theme, this::paint);
    GridData wide = new GridData(SWT.FILL, SWT.FILL, true, true);
    wide.widthHint = 0;
    figures.setLayoutData(wide);
    stiffness =
        new GainField(root, theme, "Stiffness", value -> shown.ifPresent(row -> driver.stiffness(row.name(), value)));
    damping = new GainField(root, theme, "Damping", value -> shown.ifPresent(row -> driver.damping(row.name(), value)));
    Boxes.seen(root, false);
    Boxes.seen(rule, false);
  }

  GainField stiffness() {
    return stiffness;
  }

  GainField damping() {
    return damping;
  }

  Control figures() {
    return figures;
  }

  /** Shows a joint, or nothing; whether the pane came or went. */
  boolean show(Optional<JointRow> row, boolean drivable, boolean live) {
    if (!shown.equals(row) || fresh != live) {
      shown = row;
      fresh = live;
      figures.redraw();
    }
    boolean changed = Boxes.seen(root, row.isPresent()) | Boxes.seen(rule, row.isPresent());
    row.ifPresent(joint -> gains(joint, drivable));
    return changed | arrange();
  }

  /** The fields stand beside the figures, or below them where it is narrow; whether that changed. */
  private boolean arrange() {
    boolean beside = root.getParent().getClientArea().width >= ROOM_BESIDE;
    boolean fields = !((GridData) stiffness.control().getLayoutData()).exclude
        || !((GridData) damping.control().getLayoutData()).exclude;
    int height = HEIGHT + 2 * Theme.STEP + (beside || !fields ? 0 : BELOW);
    GridData place = (GridData) root.getLayoutData();
    boolean changed = place.heightHint != height;
    place.heightHint = height;
    GridLayout layout = (GridLayout) root.getLayout();
    layout.numColumns = beside ? COLUMNS : COLUMNS - 1;
    ((GridData) figures.getLayoutData()).horizontalSpan = beside ? 1 : COLUMNS - 1;
    return changed;
  }

  private void gains(JointRow row, boolean drivable) {
    boolean stiff = row.state().modes().contains(JointMode.STIFFNESS);
    boolean damped = row.state().modes().contains(JointMode.DAMPING);
    boolean moved = Boxes.seen(stiffness.control(), stiff) | Boxes.seen(damping.control(), damped);
    double stiffnessNow = row.aim().map(Aim::stiffness).filter(v -> v.isPresent()).map(v -> v.getAsDouble())
        .orElse(row.state().reference().stiffness());
    double dampingNow = row.aim().map(Aim::damping).filter(v -> v.isPresent()).map(v -> v.getAsDouble())
        .orElse(row.state().reference().damping());
    stiffness.show(row.key(), stiffnessNow, row.measure().stiffnessUnit(), drivable);
    damping.show(row.key(), dampingNow, row.measure().dampingUnit(), drivable);
    if (moved) {
      root.layout();
    }
  }

  private void paint(GC gc, Rectangle area) {
    shown.ifPresent(row -> {
      int y = Theme.STEP;
      for (JointDetail.Entry entry : JointDetail.of(row)) {
        entry(gc, entry, y, area.width);
        y += LINE;
      }
    });
  }

  private void entry(GC gc, JointDetail.Entry entry, int y, int width) {
    gc.setFont(theme.font(Face.SMALL));
    Point size = gc.textExtent(entry.label());
    gc.setForeground(theme.color(Role.DIM));
    gc.drawText(entry.label(), 0, y + (LINE - size.y) / 2, true);
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    String text = TextFit.shorten(gc, entry.text(), width - LABEL);
    gc.setForeground(theme.color(!fresh ? Role.DIM : entry.bad() ? Role.BAD : Role.TEXT));
    gc.drawText(text, LABEL, y + (LINE - gc.textExtent(text).y) / 2, true);
  }
}
