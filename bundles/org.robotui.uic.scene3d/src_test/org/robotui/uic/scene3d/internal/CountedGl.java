package org.robotui.uic.scene3d.internal;

import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.gl.render.Gl;
import org.robotui.gl.render.Pick;
import org.robotui.gl.render.RenderRequest;
import org.robotui.gl.render.Rendered;
import org.robotui.gl.render.Renderer;

/** Graphics whose pictures are counted. */
record CountedGl(Gl gl, AtomicLong pictures) implements Gl {
  @Override
  public Renderer open(String name) {
    Renderer renderer = gl.open(name);
    return new Renderer() {
      @Override
      public CompletionStage<Rendered> render(RenderRequest request) {
        return renderer.render(request)
            .whenComplete((made, error) -> pictures.addAndGet(made instanceof Rendered.Picture ? 1 : 0));
      }

      @Override
      public void giveUp() {
        renderer.giveUp();
      }

      @Override
      public CompletionStage<Optional<Pick>> pick(RenderRequest request, int x, int y) {
        return renderer.pick(request, x, y);
      }

      @Override
      public void recycle(Rendered.Picture picture) {
        renderer.recycle(picture);
      }

      @Override
      public void close() {
        renderer.close();
      }
    };
  }
}
