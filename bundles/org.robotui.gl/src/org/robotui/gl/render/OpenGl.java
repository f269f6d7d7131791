package org.robotui.gl.render;

import java.time.Duration;
import org.robotui.gl.internal.context.GlThread;
import org.robotui.gl.internal.scene.SceneRenderer;

/**
 * The graphics of this machine, for programs and tests that have no OSGi services: the workbench gets it as {@link Gl}.
 * Owns the thread of OpenGL, which starts with the first picture.
 */
public final class OpenGl implements Gl, AutoCloseable {
  private static final String HEADLESS = "java.awt.headless";

  private static final Duration PATIENCE = Duration.ofSeconds(3);

  private final GlThread thread = new GlThread();

  /** Starts nothing yet. */
  public OpenGl() {
    // Without AWT nothing of JOGL may look for a toolkit of windows; this is asked when its classes are first used.
    if (System.getProperty(HEADLESS) == null) {
      System.setProperty(HEADLESS, "true");
    }
  }

  @Override
  public Renderer open(String name) {
    return new SceneRenderer(thread, name);
  }

  /**
   * Frees all and ends the thread, after what was asked for before; waits for that for some seconds at most. The
   * renderers are closed.
   */
  @Override
  public void close() {
    thread.close();
    try {
      thread.awaitEnd(PATIENCE);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
