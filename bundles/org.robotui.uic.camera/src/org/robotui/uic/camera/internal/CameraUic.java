package org.robotui.uic.camera.internal;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.UicContext;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Icon;
import org.robotui.ui.SwtUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;

/** The view: the tick decodes, the surface paints what was decoded last. */
final class CameraUic implements SwtUic {
  private final UicContext context;
  private final SourceId port;
  private final CameraModel model;
  private final Saver saver = new Saver();
  private final List<ViewAction> actions;
  private volatile Shot shot = Shot.NOTHING;
  private Optional<CameraSurface> surface = Optional.empty();

  CameraUic(UicContext context) {
    this.context = context;
    this.port = new SourceId(context.instance(), CameraType.IMAGE.name());
    this.model = new CameraModel(
        context.input(CameraType.IMAGE), context.input(CameraType.CAMERA_INFO), context.ruic(), port);
    this.actions = List.of(
        action("fit", "Fit", Icon.FIT, CameraSurface::fit),
        action("copy", "Copy picture", Icon.COPY, CameraSurface::copy),
        action("save", "Save picture\u2026", Icon.SAVE, s -> s.save(saver)));
  }

  @Override
  public boolean tick(long nowNanos) {
    Shot looked = model.look();
    Shot next = new Shot(looked.state(), looked.picture(), looked.info(), looked.candidates(), saver.tick(nowNanos));
    boolean changed = next.differs(shot);
    shot = next;
    return changed;
  }

  @Override
  public Control createControl(Composite parent, UiContext ui) {
    CameraSurface made = new CameraSurface(parent, ui, context.settings(), peer -> context.ruic().connect(port, peer));
    surface = Optional.of(made);
    made.show(shot);
    return made.control();
  }

  @Override
  public void refresh() {
    surface.ifPresent(s -> s.show(shot));
  }

  @Override
  public List<ViewAction> actions() {
    return actions;
  }

  @Override
  public void close() {
    // Nothing is held but memory.
  }

  private ViewAction action(String id, String label, Icon icon, Consumer<CameraSurface> run) {
    return new ViewAction(id, label, icon.id(), Optional.empty(), () -> surface.ifPresent(run));
  }
}
