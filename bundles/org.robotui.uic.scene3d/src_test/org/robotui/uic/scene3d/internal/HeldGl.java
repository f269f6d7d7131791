package org.robotui.uic.scene3d.internal;

import java.time.Duration;
import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.robotui.gl.internal.context.GlThread;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.gpu.Ledger;
import org.robotui.gl.internal.gpu.Ledger.Kind;
import org.robotui.gl.internal.scene.SceneRenderer;
import org.robotui.gl.render.Gl;
import org.robotui.gl.render.Renderer;

/** Real graphics that tell which objects of OpenGL they hold, and lose their context on demand. */
final class HeldGl implements Gl, AutoCloseable {
  private final GlThread thread = new GlThread();

  @Override
  public Renderer open(String name) {
    return new SceneRenderer(thread, name);
  }

  /** How many objects of each kind all scenes hold, after what was asked for before. */
  Map<Kind, Integer> held() {
    CompletableFuture<Map<Kind, Integer>> answer = new CompletableFuture<>();
    thread.execute(() -> answer.complete(thread.present().map(Gpu::ledger).map(HeldGl::counts).orElseGet(Map::of)));
    return answer.join();
  }

  private static Map<Kind, Integer> counts(Ledger ledger) {
    Map<Kind, Integer> counts = new EnumMap<>(Kind.class);
    for (Kind kind : Kind.values()) {
      if (ledger.held(kind) != 0) {
        counts.put(kind, ledger.held(kind));
      }
    }
    return counts;
  }

  /** Loses the context with all that is in it. */
  void lose() {
    thread.execute(thread::dropContext);
  }

  @Override
  public void close() {
    thread.close();
    try {
      thread.awaitEnd(Duration.ofMinutes(1));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
