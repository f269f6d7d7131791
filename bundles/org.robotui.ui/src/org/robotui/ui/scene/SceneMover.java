package org.robotui.ui.scene;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.robotui.geometry.Vector3;

/**
 * Moves a camera over a scene in which something may be followed: a hand that moves the scene lets go of it, and while
 * it is followed it is the one place that stays in a zoom. Display thread.
 */
public final class SceneMover {
  /** What may take a press in place of the scene. */
  @FunctionalInterface
  public interface Press {
    /**
     * The left button goes down.
     *
     * @param x pixels from the left
     * @param y pixels from the top
     * @return whether something takes it, for example a tool, so that the scene is not moved
     */
    boolean at(int x, int y);
  }

  /** Whether something is followed. */
  public interface Following {
    /**
     * Whether it is.
     *
     * @return as the user has chosen
     */
    boolean on();

    /**
     * Chooses.
     *
     * @param wanted whether it is followed from now on
     */
    void set(boolean wanted);

    /**
     * One that asks and tells others.
     *
     * @param asked whether it is
     * @param told chooses
     * @return both
     */
    static Following of(BooleanSupplier asked, Consumer<Boolean> told) {
      return new Following() {
        @Override
        public boolean on() {
          return asked.getAsBoolean();
        }

        @Override
        public void set(boolean wanted) {
          told.accept(wanted);
        }
      };
    }
  }

  private final Camera camera;
  private final Supplier<Optional<Bounds>> content;
  private final Following following;
  private final Runnable moved;

  /**
   * Where the camera is.
   *
   * @param camera what is moved
   * @param content what there is to see
   * @param following whether something is followed
   * @param moved is run after each move
   */
  public SceneMover(Camera camera, Supplier<Optional<Bounds>> content, Following following, Runnable moved) {
    this.camera = camera;
    this.content = content;
    this.following = following;
    this.moved = moved;
  }

  /**
   * What hands may hold of it.
   *
   * @param press what may take a press
   * @return what they move
   */
  public SceneHands.Held held(Press press) {
    return new Held(this, press);
  }

  /**
   * What is seen.
   *
   * @return as of the last move or paint
   */
  public Viewport viewport() {
    return camera.viewport();
  }

  /**
   * Prepares for the next paint.
   *
   * @param width of the window, pixels
   * @param height of the window, pixels
   * @param followed what stays in the middle where it is followed
   */
  public void settle(int width, int height, Optional<Vector3> followed) {
    camera.settle(width, height, content.get(), followed.filter(p -> following.on()));
  }

  /** Shows all. */
  public void fit() {
    letGo();
    camera.fit(content.get());
    moved.run();
  }

  /**
   * Shows all of something.
   *
   * @param bounds how far it reaches
   */
  public void fit(Bounds bounds) {
    letGo();
    camera.fitTo(bounds);
    moved.run();
  }

  /**
   * Moves the content with the hand.
   *
   * @param dx pixels to the right
   * @param dy pixels down
   */
  public void pan(double dx, double dy) {
    letGo();
    camera.pan(dx, dy);
    moved.run();
  }

  /**
   * Zooms.
   *
   * @param x pixels from the left
   * @param y pixels from the top
   * @param factor above 1 to come closer
   */
  public void zoom(double x, double y, double factor) {
    boolean middle = following.on();
    Viewport v = camera.viewport();
    camera.zoom(middle ? v.width() / 2.0 : x, middle ? v.height() / 2.0 : y, factor);
    moved.run();
  }

  /**
   * Puts a point in the middle.
   *
   * @param x metres
   * @param y metres
   */
  public void center(double x, double y) {
    letGo();
    camera.center(x, y);
    moved.run();
  }

  private void letGo() {
    if (following.on()) {
      following.set(false);
    }
  }

  private record Held(SceneMover mover, Press press) implements SceneHands.Held {
    @Override
    public Viewport viewport() {
      return mover.viewport();
    }

    @Override
    public void pan(double dx, double dy) {
      mover.pan(dx, dy);
    }

    @Override
    public void zoom(double x, double y, double factor) {
      mover.zoom(x, y, factor);
    }

    @Override
    public void fit() {
      mover.fit();
    }

    @Override
    public boolean press(int x, int y) {
      return press.at(x, y);
    }
  }
}
