package org.robotui.workbench.internal.dock;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.SwtUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewItem;
import org.robotui.ui.ViewKey;

/** A view that counts what is done to it; it can be made to throw. */
public class PaintedView implements SwtUic {
  public final String note;
  public int created;
  public int refreshed;
  public int painted;
  public boolean throwsOnCreate;
  public boolean throwsOnRefresh;
  public int shownItems;
  public boolean followed = true;
  public Control control;

  /** A view with a note in its title line. */
  public PaintedView(String note) {
    this.note = note;
  }

  @Override
  public Control createControl(Composite parent, UiContext context) {
    created++;
    if (throwsOnCreate) {
      throw new IllegalStateException("no control");
    }
    control = new PaintedCanvas(parent, context.theme(), (gc, area) -> {
      painted++;
      gc.setForeground(context.theme().color(Role.LINE));
      for (int x = 0; x < area.width; x += 60) {
        gc.drawLine(x, 0, x, area.height);
      }
    });
    context.note(note);
    return control;
  }

  @Override
  public void refresh() {
    refreshed++;
    if (throwsOnRefresh) {
      throw new IllegalStateException("no paint");
    }
    control.redraw();
  }

  @Override
  public List<ViewAction> actions() {
    return note.isEmpty() ? List.of()
        : List.of(
            new ViewAction("follow", "Follow", "follow", Optional.of(() -> followed), () -> followed = !followed),
            new ViewAction("fit", "Fit", "fit", Optional.empty(), () -> {}));
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(new ViewKey("F", "Follow"));
  }

  @Override
  public List<ViewItem> items() {
    return note.isEmpty() ? List.of() : List.of(new ViewItem("Item", "first of " + note, "", () -> shownItems++));
  }

  @Override
  public boolean tick(long nowNanos) {
    return true;
  }

  @Override
  public void close() {}
}
