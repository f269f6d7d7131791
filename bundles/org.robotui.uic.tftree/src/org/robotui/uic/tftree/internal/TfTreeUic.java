package org.robotui.uic.tftree.internal;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.UicContext;
import org.robotui.api.show.Subject;
import org.robotui.ui.Icon;
import org.robotui.ui.SwtUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewKey;
import org.robotui.ui.diagram.TextWidths;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.tftree.internal.model.Ask;
import org.robotui.uic.tftree.internal.model.TfTreeModel;
import org.robotui.uic.tftree.internal.view.TfTreeSurface;

/** The view: the tick takes the frames and draws the tree, the surface shows it. */
final class TfTreeUic implements SwtUic, TfTreeSurface.Wishes {
  private final UicContext context;
  private final TfTreeModel model;
  private final List<ViewAction> actions;
  private Optional<TfTreeSurface> surface = Optional.empty();

  TfTreeUic(UicContext context) {
    this.context = context;
    this.model = new TfTreeModel(context);
    model.ask(FramePreferences.read(context.settings().current()));
    this.actions = List.of(
        new ViewAction("fit", "Show the whole tree", Icon.FIT.id(), Optional.empty(),
            () -> surface.ifPresent(TfTreeSurface::fit)),
        new ViewAction("open", "Expand all", Icon.OPEN.id(), Optional.empty(), () -> ask(model.ask().opened())),
        new ViewAction("reset", "Reset: forget transforms that are not fixed", Icon.RESTART.id(), Optional.empty(),
            context.ruic()::reset),
        new ViewAction("save", "Save the drawing as PNG or SVG", Icon.SAVE.id(), Optional.empty(),
            () -> surface.ifPresent(TfTreeSurface::save)));
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos, context.settings().current().number(TfTreeType.STALE_AFTER));
  }

  @Override
  public Control createControl(Composite parent, UiContext ui) {
    TfTreeSurface made = new TfTreeSurface(parent, ui, this,
        new SubjectMenu(context.ruic(), ui.theme(), context.background()));
    surface = Optional.of(made);
    made.show(model.look(), model.ask());
    return made.control();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("0, Home", "Show the whole tree"),
        new ViewKey("+, -", "Zoom"),
        new ViewKey("Arrows", "Move"),
        new ViewKey("Enter", "Expand or collapse a frame"),
        new ViewKey("Ctrl+F", "Filter"),
        new ViewKey("Esc", "Clear the selection"));
  }

  @Override
  public void refresh() {
    surface.ifPresent(s -> s.show(model.look(), model.ask()));
  }

  @Override
  public void show(String showing, Subject subject) {
    if (subject instanceof Subject.Frame frame) {
      ask(model.ask().search("").problems(false).opened().select(Optional.of(frame.frame())));
    }
  }

  @Override
  public List<ViewAction> actions() {
    return actions;
  }

  @Override
  public Ask asked() {
    return model.ask();
  }

  @Override
  public void ask(Ask next) {
    model.ask(next);
    FramePreferences.write(context.settings(), next);
    refresh();
  }

  @Override
  public void widths(TextWidths exact) {
    model.widths(exact);
  }

  @Override
  public void close() {
    // Nothing is held but memory.
  }
}
