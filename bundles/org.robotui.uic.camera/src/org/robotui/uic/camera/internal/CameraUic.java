package org.robotui.uic.camera.internal;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;

/** The view: the tick decodes, the surface paints what was decoded last. */
final class CameraUic extends SurfaceUic<CameraSurface> {
  private static final long AGE_NANOS = 200_000_000L;

  private final UicContext context;
  private final SourceId port;
  private final CameraModel model;
  private final CameraChoices choices;
  private final Saver saver;
  private final AtomicInteger blocks = new AtomicInteger(1);
  private long told;
  private volatile Shot shot = Shot.NOTHING;

  CameraUic(UicContext context) {
    this.context = context;
    this.port = new SourceId(context.instance(), CameraType.IMAGE.name());
    this.model = new CameraModel(
        context.input(CameraType.IMAGE), context.input(CameraType.CAMERA_INFO), context.ruic(), port);
    this.choices = new CameraChoices(context.settings());
    this.saver = new Saver(context.background());
    offers().action("fit", "Show all (0)", Icon.FIT, s -> s.see(ZoomMode.FIT))
        .action("copy", "Copy picture", Icon.COPY, CameraSurface::copy)
        .action("save", "Save picture\u2026", Icon.SAVE, s -> s.save(Saver.Part.COLORS))
        .action("options", "What is shown", Icon.MORE, CameraSurface::openMenu);
  }

  @Override
  public boolean tick(long nowNanos) {
    CameraOptions options = choices.options();
    Shot next = model.look(options.rendering(), blocks.get()).with(saver.tick(nowNanos));
    boolean aged = options.details() && nowNanos - told > AGE_NANOS;
    boolean changed = next.differs(shot) || aged;
    told = changed ? nowNanos : told;
    boolean other = !next.seen().map(Shot.Shown::pixels).equals(shot.seen().map(Shot.Shown::pixels));
    surface().filter(s -> other).ifPresent(s -> s.prepare(next));
    shot = next;
    return changed;
  }

  @Override
  protected CameraSurface open(Composite parent, UiContext ui) {
    return new CameraSurface(parent, ui, context.clock(), choices, saver, peer -> context.ruic().connect(port, peer),
        blocks::set);
  }

  @Override
  protected void refresh(CameraSurface shown) {
    shown.show(shot);
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("0, 1, 2", "Show all, actual pixels, fill the view"),
        new ViewKey("+, -", "Zoom"),
        new ViewKey("Arrows", "Move"),
        new ViewKey("C", "Change the colour map"),
        new ViewKey("R", "Fix the colour range, or let it follow"),
        new ViewKey("I", "Show the pixel under the pointer"),
        new ViewKey("D", "Show details"),
        new ViewKey("L", "Show the legend"));
  }
}
