package org.robotui.rfic.ros2.internal.call;

import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.ros2.parameter.Ros2ParameterEvent;
import org.robotui.ros2.parameter.Ros2ParameterValue;
import org.robotui.ros2.parameter.Ros2Parameters;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Looks for a text among the parameters of nodes while no topic says it: asks one node after the other, each until it
 * has answered, and follows the value where it was found. For the thread that follows the graph; what is found is told
 * on another one.
 */
final class DescriptionParameter {
  private static final Logger LOG = LoggerFactory.getLogger(DescriptionParameter.class);
  private static final Duration PATIENCE = Duration.ofSeconds(3);
  /** A topic may be discovered later than the nodes. */
  private static final Duration GRACE = Duration.ofSeconds(3);
  /** So often is one asked that does not answer. */
  private static final int MOST_TRIES = 3;

  private final Ros2Node node;
  private final String name;
  private final Predicate<Ros2Name> likely;
  private final boolean others;
  private final ExecutorService worker;
  private final Consumer<String> found;
  /** How often each was asked. */
  private final Map<Ros2Name, Integer> asked = new ConcurrentHashMap<>();
  private Optional<AutoCloseable> changes = Optional.empty();
  private long lackingNanos = System.nanoTime();
  private volatile Optional<Ros2Name> holder = Optional.empty();
  private volatile boolean asking;

  /**
   * Has found nothing yet.
   *
   * @param node asks
   * @param name of the parameter
   * @param likely nodes that are asked first
   * @param others whether other nodes are asked after them
   * @param worker asks, which may take seconds
   * @param found is told the text; empty where it is there no more
   */
  DescriptionParameter(Ros2Node node, String name, Predicate<Ros2Name> likely, boolean others,
      ExecutorService worker, Consumer<String> found) {
    this.node = node;
    this.name = name;
    this.likely = likely;
    this.others = others;
    this.worker = worker;
    this.found = found;
  }

  /**
   * Looks at who is there.
   *
   * @param lacking whether no topic says the text
   * @param nodes those that can be asked
   */
  void look(boolean lacking, List<Ros2Name> nodes) {
    if (!lacking) {
      lackingNanos = System.nanoTime();
    }
    asked.keySet().retainAll(nodes);
    if (holder.filter(each -> !lacking || !nodes.contains(each)).isPresent()) {
      forget();
    } else if (holder.isEmpty() && !asking && System.nanoTime() - lackingNanos > GRACE.toNanos()) {
      nodes.stream().filter(each -> tries(each) < MOST_TRIES && (others || likely.test(each)))
          .min(Comparator.comparingInt(this::tries).thenComparing(each -> !likely.test(each))
              .thenComparing(Ros2Name::text))
          .ifPresent(this::ask);
    }
    if (holder.isPresent() && changes.isEmpty()) {
      changes = Optional.of(Ros2Parameters.follow(node, this::changed));
    }
  }

  private int tries(Ros2Name whom) {
    return asked.getOrDefault(whom, 0);
  }

  private void ask(Ros2Name whom) {
    asked.merge(whom, 1, Integer::sum);
    asking = true;
    try {
      worker.execute(() -> {
        try {
          read(whom);
        } catch (IllegalStateException e) {
          LOG.debug("our node was closed meanwhile", e);
        } finally {
          asking = false;
        }
      });
    } catch (RejectedExecutionException e) {
      LOG.debug("closed", e);
    }
  }

  private void read(Ros2Name whom) {
    try (Ros2Parameters parameters = Ros2Parameters.open(node, whom, PATIENCE)) {
      switch (parameters.get(List.of(name))) {
        case Outcome.Done<Map<String, Ros2ParameterValue>> done -> {
          asked.put(whom, MOST_TRIES);
          take(whom, done.value());
        }
        case Outcome.Refused<?> refused -> asked.put(whom, MOST_TRIES);
        case Outcome<?> silent -> {
          // it has its turn again after the others
        }
      }
    }
  }

  private void take(Ros2Name whom, Map<String, Ros2ParameterValue> values) {
    if (values.get(name) instanceof Ros2ParameterValue.OfText text && !text.value().isBlank()) {
      holder = Optional.of(whom);
      found.accept(text.value());
    }
  }

  private void changed(Ros2ParameterEvent event) {
    if (holder.filter(event.node()::equals).isPresent()) {
      take(event.node(), event.values());
    }
  }

  private void forget() {
    holder.ifPresent(asked::remove);
    holder = Optional.empty();
    found.accept("");
    unfollow();
  }

  private void unfollow() {
    changes.ifPresent(each -> {
      try {
        each.close();
      } catch (Exception e) {
        throw new IllegalStateException("parameters are followed for ever", e);
      }
    });
    changes = Optional.empty();
  }
}
