package org.robotui.uic.postures.internal;

import java.util.List;
import java.util.concurrent.Executor;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.config.SettingsStore;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.uic.postures.internal.model.PosturesModel;
import org.robotui.uic.postures.internal.view.PosturesSurface;

/** The view: the tick takes what came and goes on, the surface lists. */
final class PosturesUic extends SurfaceUic<PosturesSurface> implements PosturesSurface.Choices {
  private static final double HUNDREDTHS = 100;

  private final SettingsStore settings;
  private final Executor background;
  private final PosturesModel model;

  PosturesUic(UicContext context) {
    settings = context.settings();
    background = context.background();
    model = new PosturesModel(context, context.input(PosturesPorts.CONTROL), context.input(PosturesPorts.PLUGINS),
        context.caller(PosturesPorts.VERBS),
        new PosturesModel.Names(PosturesType.PLUGIN, PosturesType.GUIDE, PosturesType.SPEED, PosturesType.LOOP));
    offers().action("open", "Open postures\u2026", Icon.OPEN, shown -> shown.files().open())
        .action("save", "Save postures\u2026", Icon.SAVE, shown -> shown.files().save());
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos);
  }

  @Override
  protected PosturesSurface open(Composite parent, UiContext ui) {
    return new PosturesSurface(parent, ui, model, this);
  }

  @Override
  protected void refresh(PosturesSurface shown) {
    shown.refresh();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("Insert", "Store the present posture"),
        new ViewKey("Enter", "Go to the posture"),
        new ViewKey("F2", "Rename"),
        new ViewKey("Alt+Up, down", "Earlier, later"),
        new ViewKey("Delete", "Remove"),
        new ViewKey("Ctrl+Z", "Undo"),
        new ViewKey("Esc", "End what runs"));
  }

  @Override
  public void close() {
    model.stop();
  }

  @Override
  public void loop(boolean wanted) {
    settings.set(PosturesType.LOOP, wanted);
  }

  @Override
  public void speed(double share) {
    settings.set(PosturesType.SPEED, Math.max(1, Math.round(share * HUNDREDTHS)) / HUNDREDTHS);
  }

  @Override
  public void background(Runnable task) {
    background.execute(task);
  }

  PosturesModel model() {
    return model;
  }

  /** What is seen of it, once it is shown. */
  PosturesSurface shown() {
    return surface().orElseThrow();
  }

  /** Selects a posture by its place. */
  void select(int index) {
    surface().ifPresent(shown -> shown.select(index));
  }
}
