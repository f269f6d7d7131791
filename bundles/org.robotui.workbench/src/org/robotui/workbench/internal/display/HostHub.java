package org.robotui.workbench.internal.display;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.robotui.api.host.ConfigChange;
import org.robotui.api.host.Host;
import org.robotui.api.host.HostListener;
import org.robotui.api.show.Subject;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Brings what core tells to the display thread: each thing once for any number of calls, and never more than one
 * pending task, so that a slow display cannot be flooded. A client that throws keeps neither the others from being
 * told, nor itself from being told what comes next.
 */
public final class HostHub implements HostListener, AutoCloseable {
  /** Is told on the display thread. */
  public interface Client {
    /** A RUIC came or went. */
    default void ruicsChanged() {}

    /** State, components or matches of a RUIC changed. */
    default void ruicChanged(String ruic) {}

    /** A view has something new to show. */
    default void frameReady(String ruic, String uic) {}

    /** The user wants to see another RUIC in place of one. */
    default void showWanted(String from, String wanted) {}

    /** The user wants to see something in a view. */
    default void viewWanted(String ruic, String uic, String showing, Subject subject) {}

    /** The user should know something. */
    default void alert(String ruic, String message) {}

    /** Something about the window that soon is over. */
    default void notice(String message) {}

    /** The file of a configuration that runs was changed. */
    default void configurationChanged(ConfigChange change) {}
  }

  private static final Logger LOG = LoggerFactory.getLogger(HostHub.class);
  private static final int MOST_EVENTS = 10_000;

  /** What happened; equal events are one. */
  private sealed interface Event {
    /** A RUIC came or went. */
    record Ruics() implements Event {}

    /** A RUIC changed. */
    record Changed(String ruic) implements Event {}

    /** A view has a frame. */
    record Frame(String ruic, String uic) implements Event {}

    /** Another RUIC is to be shown. */
    record Show(String from, String wanted) implements Event {}

    /** Something is to be shown in a view. */
    record View(String ruic, String uic, String showing, Subject subject) implements Event {}

    /** An alert. */
    record Alert(String ruic, String message) implements Event {}

    /** A file. */
    record Config(ConfigChange change) implements Event {}

    /** A notice. */
    record Notice(String message) implements Event {}
  }

  private final Executor display;
  private final Host.Subscription subscription;
  private final List<Client> clients = new CopyOnWriteArrayList<>();
  private final Set<Event> pending = new LinkedHashSet<>();

  /**
   * Listens to a host from now on.
   *
   * @param host the core
   * @param display runs tasks on the display thread, later
   */
  public HostHub(Host host, Executor display) {
    this.display = display;
    subscription = host.listen(this);
  }

  /** Adds a client; running the result takes it away. Display thread. */
  public Runnable add(Client client) {
    clients.add(client);
    return () -> clients.remove(client);
  }

  @Override
  public void ruicsChanged() {
    post(new Event.Ruics());
  }

  @Override
  public void ruicChanged(String ruic) {
    post(new Event.Changed(ruic));
  }

  @Override
  public void frameReady(String ruic, String uic) {
    post(new Event.Frame(ruic, uic));
  }

  @Override
  public void showWanted(String from, String wanted) {
    post(new Event.Show(from, wanted));
  }

  @Override
  public void viewWanted(String ruic, String uic, String showing, Subject subject) {
    post(new Event.View(ruic, uic, showing, subject));
  }

  @Override
  public void alert(String ruic, String message) {
    post(new Event.Alert(ruic, message));
  }

  @Override
  public void notice(String message) {
    post(new Event.Notice(message));
  }

  @Override
  public void configurationChanged(ConfigChange change) {
    post(new Event.Config(change));
  }

  @Override
  public void close() {
    subscription.close();
    clients.clear();
  }

  private void post(Event event) {
    boolean first;
    synchronized (pending) {
      first = pending.isEmpty();
      if (pending.size() < MOST_EVENTS) {
        pending.add(event);
      }
    }
    if (first) {
      display.execute(this::deliver);
    }
  }

  private void deliver() {
    List<Event> events;
    synchronized (pending) {
      events = List.copyOf(pending);
      pending.clear();
    }
    for (Event event : events) {
      tell(event);
    }
  }

  private void tell(Event event) {
    Consumer<Client> call = switch (event) {
      case Event.Ruics r -> Client::ruicsChanged;
      case Event.Changed c -> client -> client.ruicChanged(c.ruic());
      case Event.Frame f -> client -> client.frameReady(f.ruic(), f.uic());
      case Event.Show s -> client -> client.showWanted(s.from(), s.wanted());
      case Event.View v -> client -> client.viewWanted(v.ruic(), v.uic(), v.showing(), v.subject());
      case Event.Alert a -> client -> client.alert(a.ruic(), a.message());
      case Event.Config c -> client -> client.configurationChanged(c.change());
      case Event.Notice n -> client -> client.notice(n.message());
    };
    clients.forEach(client -> tell(client, call, event));
  }

  private static void tell(Client client, Consumer<Client> call, Event event) {
    try {
      call.accept(client);
    } catch (RuntimeException | Error e) { // views are foreign code, which may throw anything
      LOG.error("{} failed when told of {}", client.getClass().getName(), event, e);
    }
  }
}
