package org.robotui.gl.internal.scene;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.gl.internal.context.GlThread;
import org.robotui.gl.internal.context.NoOpenGl;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.render.Pick;
import org.robotui.gl.render.RenderRequest;
import org.robotui.gl.render.Rendered;
import org.robotui.gl.render.Renderer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The pictures of one scene, made on the thread of OpenGL. At most one request waits there. */
public final class SceneRenderer implements Renderer {
  private static final Logger LOG = LoggerFactory.getLogger(SceneRenderer.class);
  private static final int MOST_PICKS = 16;
  private static final Rendered CLOSED = new Rendered.Unavailable("This scene is closed.", "Open it again.");

  private record Waiting(RenderRequest request, CompletableFuture<Rendered> answer) {}

  private final GlThread thread;
  private final String name;
  private final PixelShelf shelf = new PixelShelf();
  private final AtomicInteger picks = new AtomicInteger();
  private Optional<Waiting> waiting = Optional.empty();
  private boolean closed;
  /** Looked at between the pieces of a picture in work. */
  private volatile boolean givenUp;
  /** On the thread of OpenGL only. */
  private Optional<Scene> scene = Optional.empty();

  /**
   * A renderer without pictures.
   *
   * @param thread of OpenGL
   * @param name for messages
   */
  public SceneRenderer(GlThread thread, String name) {
    this.thread = thread;
    this.name = name;
  }

  @Override
  public CompletionStage<Rendered> render(RenderRequest request) {
    CompletableFuture<Rendered> answer = new CompletableFuture<>();
    Optional<Waiting> replaced = Optional.empty();
    synchronized (this) {
      boolean refused = closed;
      if (!refused) {
        replaced = waiting;
        waiting = Optional.of(new Waiting(request, answer));
        refused = replaced.isEmpty() && !thread.execute(this::work);
      }
      if (refused) {
        waiting = Optional.empty();
        answer.complete(CLOSED);
      }
    }
    replaced.ifPresent(old -> old.answer.complete(new Rendered.Skipped()));
    return answer.minimalCompletionStage();
  }

  private void work() {
    takeWaiting().ifPresent(next -> {
      Rendered made = rendered(next.request);
      thread.answer(() -> next.answer.complete(made));
    });
  }

  private synchronized Optional<Waiting> takeWaiting() {
    Optional<Waiting> next = waiting;
    waiting = Optional.empty();
    givenUp = false;
    return next;
  }

  private Rendered rendered(RenderRequest request) {
    try {
      return thread.with(gpu -> in(gpu).render(request));
    } catch (NoOpenGl e) {
      return new Rendered.Unavailable(e.getMessage(), e.remedy());
    }
  }

  @Override
  public void giveUp() {
    Optional<Waiting> left;
    synchronized (this) {
      givenUp = true;
      left = waiting;
      waiting = Optional.empty();
    }
    left.ifPresent(last -> last.answer.complete(new Rendered.Skipped()));
  }

  @Override
  public CompletionStage<Optional<Pick>> pick(RenderRequest request, int x, int y) {
    givenUp = true;
    CompletableFuture<Optional<Pick>> answer = new CompletableFuture<>();
    boolean taken = picks.incrementAndGet() <= MOST_PICKS && !isClosed() && thread.execute(() -> {
      picks.decrementAndGet();
      answer.complete(picked(request, x, y));
    });
    if (!taken) {
      picks.decrementAndGet();
      answer.complete(Optional.empty());
    }
    return answer.minimalCompletionStage();
  }

  private Optional<Pick> picked(RenderRequest request, int x, int y) {
    try {
      return thread.with(gpu -> in(gpu).pick(request, x, y));
    } catch (NoOpenGl e) {
      LOG.debug("{}: nothing is found without OpenGL", name, e);
      return Optional.empty();
    }
  }

  /** The scene in the present context: another one after a context was lost. */
  private Scene in(Gpu gpu) {
    Scene present = scene.filter(old -> old.isIn(gpu)).orElseGet(() -> new Scene(gpu, shelf, () -> givenUp));
    scene = Optional.of(present);
    return present;
  }

  @Override
  public void recycle(Rendered.Picture picture) {
    if (!isClosed()) {
      shelf.giveBack(picture.rgb());
    }
  }

  private synchronized boolean isClosed() {
    return closed;
  }

  @Override
  public void close() {
    Optional<Waiting> left;
    synchronized (this) {
      closed = true;
      givenUp = true;
      left = waiting;
      waiting = Optional.empty();
    }
    shelf.clear();
    left.ifPresent(last -> last.answer.complete(CLOSED));
    thread.execute(this::free);
  }

  private void free() {
    scene.filter(old -> thread.present().filter(old::isIn).isPresent()).ifPresent(Scene::delete);
    scene = Optional.empty();
  }
}
