package org.robotui.uic.scene3d.internal.render;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.robotui.gl.render.Gl;
import org.robotui.gl.render.Pick;
import org.robotui.gl.render.RenderRequest;
import org.robotui.gl.render.Rendered;
import org.robotui.gl.render.Renderer;

/** Answers when the test says so, or at once a picture in the colour of the ground. */
public final class FakeGl implements Gl {
  private static final int RECYCLED = 0xff00ff;

  public final List<RenderRequest> requests = new ArrayList<>();
  public final List<CompletableFuture<Rendered>> answers = new ArrayList<>();
  public Optional<Pick> hit = Optional.empty();
  public boolean atOnce;
  public Optional<Rendered.Unavailable> none = Optional.empty();
  public int open;
  public int recycled;
  public int givenUp;

  @Override
  public Renderer open(String name) {
    open++;
    return new Renderer() {
      @Override
      public CompletionStage<Rendered> render(RenderRequest request) {
        requests.add(request);
        CompletableFuture<Rendered> answer = new CompletableFuture<>();
        answers.add(answer);
        if (atOnce) {
          answer.complete(none.<Rendered>map(n -> n).orElseGet(() -> picture(request, 0.01, 100, 0)));
        }
        return answer;
      }

      @Override
      public CompletionStage<Optional<Pick>> pick(RenderRequest request, int x, int y) {
        return CompletableFuture.completedFuture(hit);
      }

      @Override
      public void giveUp() {
        givenUp++;
        answers.getLast().complete(new Rendered.Skipped());
      }

      @Override
      public void recycle(Rendered.Picture picture) {
        Arrays.fill(picture.rgb(), RECYCLED);
        recycled++;
      }

      @Override
      public void close() {
        open--;
      }
    };
  }

  static Rendered.Picture picture(RenderRequest r, double seconds, long points, long leftOut) {
    int[] rgb = new int[r.width() * r.height()];
    Arrays.fill(rgb, r.background().packed() >>> 8);
    return new Rendered.Picture(r.width(), r.height(), rgb, new Rendered.Figures(seconds, points, leftOut, 0, 0, 0, 0),
        List.of());
  }

  void answer(double seconds, long points, long leftOut) {
    answers.getLast().complete(picture(requests.getLast(), seconds, points, leftOut));
  }
}
