package org.robotui.gl.render;

import java.util.Optional;
import java.util.concurrent.CompletionStage;

/**
 * Makes the pictures of one scene and keeps what is needed for them on the graphics card. Methods are called from any
 * thread and return at once. Pictures complete one after the other on a thread that may be held up while the next one
 * is drawn; what was found completes on the thread of OpenGL, which must not be.
 */
public interface Renderer extends AutoCloseable {
  /**
   * Draws. One picture at a time is worked on, and the newest request waits behind it: one that it replaces completes
   * with {@link Rendered.Skipped}.
   *
   * @param request what to draw
   * @return the picture, or why there is none
   */
  CompletionStage<Rendered> render(RenderRequest request);

  /**
   * Gives up what is in work or waits: it completes with {@link Rendered.Skipped}, soon also where it has millions of
   * points. For a view that wants something else at once, as when the camera is moved while a picture of all points is
   * drawn.
   */
  void giveUp();

  /**
   * Finds what lies under a pixel. A picture in work is given up for it.
   *
   * @param request what is drawn
   * @param x pixels from the left
   * @param y pixels from the top
   * @return what is hit first within some pixels
   */
  CompletionStage<Optional<Pick>> pick(RenderRequest request, int x, int y);

  /**
   * Takes back the pixels of a picture, for one of the next pictures of that size to be written into: a view that does
   * so after it has copied them makes no garbage of megabytes a picture. A picture that is not handed back stays as it
   * is.
   *
   * @param picture of this renderer, whose pixels nobody reads any more; handed back once
   */
  void recycle(Rendered.Picture picture);

  /** Frees all on the graphics card. Returns at once; later requests complete with {@link Rendered.Unavailable}. */
  @Override
  void close();
}
