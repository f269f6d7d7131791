package org.robotui.core.internal.life;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;

/** The worker of a RUIC until the RUIC ends. Any thread. */
final class RuicWorker {
  private final SerialWorker worker;
  private final CompletableFuture<List<String>> ended = new CompletableFuture<>();

  RuicWorker(String name) {
    worker = new SerialWorker(name);
  }

  SerialWorker serial() {
    return worker;
  }

  /** Completes when the RUIC has ended, with what could not be ended. */
  CompletableFuture<List<String>> ended() {
    return ended;
  }

  /** Does something, one after the other; nothing once the RUIC has ended. */
  void run(Runnable task) {
    worker.execute(() -> {
      if (!ended.isDone()) {
        task.run();
      }
    });
  }

  /** Does something that has an answer; completes with what stands for it where that fails, or the RUIC has ended. */
  <T> CompletableFuture<T> ask(Supplier<T> task, T none) {
    CompletableFuture<T> answer = new CompletableFuture<>();
    run(() -> {
      try {
        answer.complete(task.get());
      } finally {
        answer.complete(none);
      }
    });
    ended.thenRun(() -> answer.complete(none));
    return answer;
  }

  /** The RUIC has ended. */
  void end(Runnable told, List<String> left) {
    worker.close();
    told.run();
    ended.complete(left);
  }
}
