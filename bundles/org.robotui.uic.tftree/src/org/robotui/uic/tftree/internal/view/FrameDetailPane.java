package org.robotui.uic.tftree.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.data.FrameId;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowTable;
import org.robotui.ui.diagram.DiagramWishes;
import org.robotui.uic.tftree.internal.model.Ask;
import org.robotui.uic.tftree.internal.model.Ask.Reference;
import org.robotui.uic.tftree.internal.model.FrameDetail;

/** Where the selected frame lies, and all that is known of its transform. Display thread. */
final class FrameDetailPane {
  private static final int HEAD = 34;
  private static final double NAME_SHARE = 2;
  private static final double VALUE_SHARE = 5;

  private final Theme theme;
  private final DiagramWishes<Ask> wishes;
  private final Composite root;
  private final PaintedCanvas head;
  private final Composite line;
  private final QuietButton reference;
  private final NoticeLine missing;
  private final RowTable<FrameDetail.Value> values;
  private Optional<FrameDetail> detail = Optional.empty();

  FrameDetailPane(Composite parent, Theme theme, DiagramWishes<Ask> wishes, Runnable close) {
    this.theme = theme;
    this.wishes = wishes;
    root = Boxes.panel(parent, theme, 1);
    Composite top = Boxes.panel(root, theme, 3);
    top.setLayoutData(Boxes.line());
    head = new PaintedCanvas(top, theme, this::paint);
    head.setLayoutData(Boxes.line(HEAD));
    new QuietButton(top, theme, this::copy).icon(Icon.COPY).hint("Copy all of it");
    new QuietButton(top, theme, close).icon(Icon.CLOSE).hint("Close the details (Esc)");
    line = Boxes.bar(root, theme, 1);
    reference =
        new QuietButton(line, theme, this::choose).icon(Icon.OPEN).hint("Choose in which frame the pose is shown");
    missing = new NoticeLine(root, theme, Face.BODY);
    values = new RowTable<>(root, theme, List.of(
        Column.<FrameDetail.Value>words("Name", FrameDetail.Value::name).weight(NAME_SHARE).role(Role.DIM),
        Column.<FrameDetail.Value>values("Value", FrameDetail.Value::value).weight(VALUE_SHARE)),
        FrameDetail.Value::name);
    values.list().named("Pose and transform").several();
    values.control().setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    values.list().control().addListener(SWT.KeyDown, e -> {
      if (e.keyCode == SWT.ESC) {
        close.run();
      }
    });
    Boxes.seen(missing.control(), false);
  }

  void show(Optional<FrameDetail> next) {
    if (next.isEmpty() || next.equals(detail)) {
      return;
    }
    boolean renamed = !detail.map(FrameDetail::reference).equals(next.map(FrameDetail::reference));
    detail = next;
    head.redraw();
    if (renamed) {
      reference.text("in " + next.get().reference());
      line.layout();
    }
    next.get().missing().ifPresent(why -> missing.show(Health.WARNING, why));
    if (Boxes.seen(missing.control(), next.get().missing().isPresent())) {
      root.layout();
    }
    values.show(next.get().values());
  }

  private void paint(GC gc, Rectangle area) {
    detail.ifPresent(d -> {
      gc.setFont(theme.font(Face.TITLE));
      String name = TextFit.inTheMiddle(gc, d.frame().name(), area.width - 2 * Theme.EDGE);
      gc.drawText(name, Theme.EDGE, (area.height - gc.textExtent(name).y) / 2, true);
    });
  }

  private void choose() {
    Reference now = wishes.asked().reference();
    PopupMenu menu = new PopupMenu(reference);
    menu.radio("In the root of its tree", now instanceof Reference.Root, () -> in(new Reference.Root()));
    menu.radio("In its parent frame", now instanceof Reference.Parent, () -> in(new Reference.Parent()));
    if (now instanceof Reference.Pinned pinned) {
      menu.radio("Always in " + pinned.frame(), true, () -> in(pinned));
    }
    menu.line();
    detail.map(FrameDetail::frame).ifPresent(frame -> menu.push("From now on in " + frame, () -> pin(frame)));
    menu.openBelow(reference);
  }

  private void pin(FrameId frame) {
    in(new Reference.Pinned(frame));
  }

  private void in(Reference next) {
    wishes.ask(wishes.asked().in(next));
  }

  private void copy() {
    detail.map(FrameDetail::text).ifPresent(Clipboards::copy);
  }

  Control control() {
    return root;
  }
}
