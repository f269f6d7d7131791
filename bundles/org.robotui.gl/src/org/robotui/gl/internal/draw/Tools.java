package org.robotui.gl.internal.draw;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.text.GlyphTexture;

/**
 * What all pictures of a context share.
 *
 * @param programs the shaders
 * @param glyphs of labels
 * @param background where meshes are reduced
 */
public record Tools(Programs programs, GlyphTexture glyphs, ExecutorService background) {
  private static final long IDLE_SECONDS = 5;

  /**
   * Makes them; each comes to the graphics card when it is first needed.
   *
   * @param gpu the context
   * @return the tools
   */
  public static Tools of(Gpu gpu) {
    return new Tools(new Programs(gpu), new GlyphTexture(gpu), worker());
  }

  /** One thread, which is there while it has something to do. */
  private static ExecutorService worker() {
    ThreadPoolExecutor made = new ThreadPoolExecutor(1, 1, IDLE_SECONDS, TimeUnit.SECONDS, new LinkedBlockingQueue<>(),
        task -> Thread.ofPlatform().name("Mesh reduction").daemon().priority(Thread.MIN_PRIORITY).unstarted(task));
    made.allowCoreThreadTimeOut(true);
    return made;
  }

  /** Frees them. */
  public void delete() {
    background.shutdownNow();
    programs.delete();
    glyphs.delete();
  }
}
