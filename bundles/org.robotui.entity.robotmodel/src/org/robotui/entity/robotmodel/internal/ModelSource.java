package org.robotui.entity.robotmodel.internal;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicReference;
import org.robotui.api.config.Settings;
import org.robotui.data.joint.RobotDescription;
import org.robotui.gl.display.DisplayContext;

/**
 * The model of a description, loaded in the background. Until another one is there, the last one stays. Worker thread
 * of the scene, but for the load.
 */
final class ModelSource implements AutoCloseable {
  private final DisplayContext context;
  private final ModelShelf shelf;
  private final AtomicReference<Answer> answered = new AtomicReference<>();
  private Optional<RobotDescription> description = Optional.empty();
  private Optional<LoadRequest> requested = Optional.empty();
  private Optional<Answer> taken = Optional.empty();
  private volatile boolean closed;

  ModelSource(DisplayContext context, ModelShelf shelf) {
    this.context = context;
    this.shelf = shelf;
  }

  /**
   * What came of a request.
   *
   * @param robot whose model it is
   * @param request what was asked for
   * @param loaded what is there now
   */
  record Answer(String robot, LoadRequest request, Loaded loaded) {}

  /** From now on this is the robot. */
  void told(RobotDescription told) {
    description = Optional.of(told);
  }

  boolean described() {
    return description.isPresent();
  }

  /** Asks for what is not there yet; true where another answer came since the last call. */
  boolean update(boolean collision, Settings settings) {
    List<String> packages = settings.list(RobotModelType.PACKAGES).stream().map(Object::toString).toList();
    description.map(d -> new LoadRequest(d, collision, packages)).filter(r -> !requested.equals(Optional.of(r)))
        .ifPresent(this::load);
    Answer answer = answered.getAndSet(null);
    if (answer == null || !requested.equals(Optional.of(answer.request))) {
      return false;
    }
    taken = Optional.of(answer);
    return true;
  }

  Optional<Answer> taken() {
    return taken;
  }

  private void load(LoadRequest request) {
    requested = Optional.of(request);
    try {
      context.background().execute(() -> {
        Loaded loaded = shelf.load(request);
        if (!closed) {
          answered.set(new Answer(request.description().robot(), request, loaded));
          context.wake();
        }
      });
    } catch (RejectedExecutionException e) {
      // the scene ends: nobody will look at what is not loaded
      requested = Optional.empty();
    }
  }

  @Override
  public void close() {
    closed = true;
    answered.set(null);
    taken = Optional.empty();
  }
}
