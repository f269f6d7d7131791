package org.robotui.ui.scene;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.robotui.geometry.Vector3;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.UiContext;

/**
 * The control of a view from above: a scene that is moved by hands, follows something, is painted at once or in turns,
 * and over which the view paints what does not move with it. Display thread.
 */
public final class SceneControl {
  /** What is special to a view. */
  public interface View {
    /**
     * What is to be seen of the scene.
     *
     * @return false where there is nothing to be shown as if it were true
     */
    boolean shows();

    /**
     * What stays in the middle while it is followed.
     *
     * @return the place in the scene, or none
     */
    Optional<Vector3> followed();

    /**
     * Paints over the scene.
     *
     * @param painter in the scene's coordinates
     * @param area all of the control, pixels
     */
    void over(Painter painter, Rectangle area);

    /**
     * What the title line says.
     *
     * @return some words
     */
    String note();
  }

  private final UiContext context;
  private final Scene scene;
  private final SceneMover.Following following;
  private final View view;
  private final PaintedCanvas surface;
  private final SceneMover mover;
  private final ScenePicture picture;
  private String note = "";

  /**
   * Of a scene.
   *
   * @param parent the parent
   * @param context of the window
   * @param scene what is painted; is disposed with the control
   * @param camera from where
   * @param following whether something is followed
   * @param view what is special to it
   */
  public SceneControl(Composite parent, UiContext context, Scene scene, Camera camera, SceneMover.Following following,
      View view) {
    this.context = context;
    this.scene = scene;
    this.following = following;
    this.view = view;
    surface = new PaintedCanvas(parent, context.theme(), this::paint);
    mover = new SceneMover(camera, scene::bounds, following, this::repaint);
    picture = new ScenePicture(scene, surface, context.theme(), context::nanos);
    surface.atEnd(scene::dispose);
  }

  /**
   * What is painted on.
   *
   * @return the control
   */
  public PaintedCanvas surface() {
    return surface;
  }

  /**
   * Moves what is seen.
   *
   * @return the mover
   */
  public SceneMover mover() {
    return mover;
  }

  /** Paints soon what the last ticks prepared. */
  public void refresh() {
    if (!surface.isDisposed()) {
      sayNote();
      picture.refresh();
      if (following.on()) {
        // The camera moves with what is followed, which is seen by painting.
        surface.requestPaint();
      }
    }
  }

  /** Paints soon what hands have changed: the camera, or what lies over the scene. */
  public void repaint() {
    if (!surface.isDisposed()) {
      refresh();
      surface.requestPaint();
    }
  }

  /**
   * What lies at a pixel, topmost first.
   *
   * @param pixel from the upper left
   * @param tolerance how far away still counts, pixels
   * @return the visible layers that have something there
   */
  public List<Scene.Hit> hits(Point pixel, double tolerance) {
    Viewport v = mover.viewport();
    return scene.at(v.worldX(pixel.x), v.worldY(pixel.y), tolerance / v.scale());
  }

  private void paint(GC gc, Rectangle area) {
    mover.settle(area.width, area.height, view.followed());
    Painter painter = new Painter(gc, mover.viewport(), context.theme());
    if (view.shows()) {
      picture.paint(painter);
      painter.opacity(1);
    }
    view.over(painter, area);
    if (painter.wantsAgain()) {
      surface.requestPaint();
    }
  }

  private void sayNote() {
    String next = view.note();
    if (!next.equals(note)) {
      note = next;
      context.note(next);
    }
  }
}
