package org.robotui.player.internal.client;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.robotui.net.call.Outcome;
import org.robotui.net.log.LogThrottle;
import org.robotui.player.client.DeviceListener;
import org.robotui.player.client.DeviceState;
import org.robotui.player.client.Subscription;
import org.robotui.player.interfaces.Server;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.DeviceId;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One device as a client has it: who listens, and whether the server opened it. */
public final class DeviceLink {

  private static final Logger LOG = LoggerFactory.getLogger(DeviceLink.class);
  private static final int ACCESS = 3;
  private static final int OPEN = 1;
  private static final int CLOSE = 2;

  private final DeviceId id;
  private final ClientRuntime client;
  private final String name;
  private final List<DeviceListener> listeners = new CopyOnWriteArrayList<>();
  private final LogThrottle failures = new LogThrottle();
  private Optional<Connection> openedOn = Optional.empty();
  private volatile DeviceState state = new DeviceState.Unused();

  DeviceLink(DeviceId id, ClientRuntime client) {
    this.id = id;
    this.client = client;
    this.name = client.layouts().nameOf(id.at(0, 0));
  }

  public DeviceId id() {
    return id;
  }

  public String name() {
    return name;
  }

  public ClientRuntime client() {
    return client;
  }

  public DeviceState state() {
    return state;
  }

  /** The device's address as the server writes it; empty without a link. */
  public Optional<DeviceAddress> address() {
    return client.address(id);
  }

  /** Adds a listener; the first one opens the device. */
  public Subscription subscribe(DeviceListener listener) {
    // as two listeners that are equal are still two
    DeviceListener own = new Own(listener);
    listeners.add(own);
    if (state instanceof DeviceState.Unused) {
      change(new DeviceState.Waiting());
    } else {
      tell(own, state);
    }
    openAgain();
    return () -> unsubscribe(own);
  }

  private record Own(DeviceListener listener) implements DeviceListener {

    @Override
    public void onData(PlayerMessage message, long receiveNanos) {
      listener.onData(message, receiveNanos);
    }

    @Override
    public void onState(DeviceState state) {
      listener.onState(state);
    }

    @Override
    public boolean equals(Object other) {
      return this == other;
    }

    @Override
    public int hashCode() {
      return System.identityHashCode(this);
    }
  }

  private void unsubscribe(DeviceListener listener) {
    if (listeners.remove(listener) && listeners.isEmpty()) {
      Optional<Connection> opened;
      synchronized (this) {
        opened = openedOn;
        openedOn = Optional.empty();
      }
      change(new DeviceState.Unused());
      if (opened.isPresent() && opened.equals(client.current())) {
        access(CLOSE);
      }
    }
  }

  /** Opens the device on the present connection, if somebody listens and it was not done yet. */
  void openAgain() {
    synchronized (this) {
      Optional<Connection> now = client.current();
      if (listeners.isEmpty() || now.isEmpty() || now.equals(openedOn)) {
        return;
      }
      openedOn = now;
    }
    access(OPEN).thenAccept(this::opened);
  }

  /**
   * Closes and opens the device on the present connection; never waits. What is refused then is told as for the first
   * time.
   */
  public void reopen() {
    if (state instanceof DeviceState.Open) {
      access(CLOSE);
      access(OPEN).thenAccept(this::opened);
    }
  }

  private CompletableFuture<Outcome<Server.Access>> access(int mode) {
    return address().map(address -> ask(address, mode))
        .orElseGet(
            () -> CompletableFuture.completedFuture(new Outcome.Failed<>("there is no link to " + client.peer())));
  }

  private CompletableFuture<Outcome<Server.Access>> ask(DeviceAddress address, int mode) {
    Server.Device device = new Server.Device(Integer.toUnsignedLong(address.host()),
        Integer.toUnsignedLong(address.robot()), id.interfaceCode(),
        id.index());
    ByteBuffer question = client.layouts().question(Server.ACCESS).encode(new Server.Access(device, mode, ""));
    DeviceAddress server = client.address(DeviceId.SERVER).orElse(address);
    return client.request(PlayerMessage.of(server, MessageType.REQUEST, ACCESS, question), "opening " + name)
        .thenApply(this::granted);
  }

  private Outcome<Server.Access> granted(Outcome<PlayerMessage> outcome) {
    return outcome instanceof Outcome.Done<PlayerMessage> done ? decoded(done.value()) : outcome.map(none -> {
      throw new IllegalStateException("only Done has a value");
    });
  }

  private Outcome<Server.Access> decoded(PlayerMessage answer) {
    try {
      return new Outcome.Done<>(client.layouts().answer(Server.ACCESS).decode(answer.payload()));
    } catch (PlayerException e) {
      return new Outcome.Failed<>(client.peer() + ": " + e.getMessage());
    }
  }

  private void opened(Outcome<Server.Access> outcome) {
    if (outcome instanceof Outcome.Done<Server.Access> done && done.value().mode() == OPEN) {
      changeIfUsed(new DeviceState.Open(done.value().driver()));
    } else if (outcome instanceof Outcome.Failed<Server.Access> && client.current().isEmpty()) {
      LOG.debug("{}: {}", name, outcome.reason());
    } else {
      String why = outcome.reason().isEmpty() ? name + " at " + client.peer() + " was not opened" : outcome.reason();
      changeIfUsed(new DeviceState.Refused(why));
    }
  }

  private void changeIfUsed(DeviceState next) {
    if (!listeners.isEmpty()) {
      change(next);
    }
  }

  void lost(String reason) {
    LOG.debug("{}: {}", name, reason);
    synchronized (this) {
      openedOn = Optional.empty();
    }
    changeIfUsed(new DeviceState.Waiting());
  }

  void data(PlayerMessage message, long receiveNanos) {
    listeners.forEach(each -> guarded(each, listener -> listener.onData(message, receiveNanos)));
  }

  private void change(DeviceState next) {
    if (!next.equals(state)) {
      state = next;
      listeners.forEach(each -> tell(each, next));
    }
  }

  private void tell(DeviceListener listener, DeviceState next) {
    guarded(listener, each -> each.onState(next));
  }

  private void guarded(DeviceListener listener, Consumer<DeviceListener> call) {
    try {
      call.accept(listener);
    } catch (RuntimeException e) {
      if (failures.admit()) {
        LOG.error("{} at {}: a listener failed ({} so far)", name, client.peer(), failures.count(), e);
      }
    }
  }

  /** Asks the device; never waits. */
  public CompletableFuture<Outcome<PlayerMessage>> request(int subtype, ByteBuffer question, String what) {
    String title = what + " of " + name;
    return address()
        .map(address -> client.request(PlayerMessage.of(address, MessageType.REQUEST, subtype, question), title))
        .orElseGet(() -> CompletableFuture
            .completedFuture(new Outcome.Failed<>(title + ": there is no link to " + client.peer())));
  }

  /** Commands the device, if it is open; never waits. */
  public boolean command(int subtype, ByteBuffer command) {
    return state instanceof DeviceState.Open && commandUnopened(subtype, command);
  }

  /** Commands the device, open or not; never waits. */
  public boolean commandUnopened(int subtype, ByteBuffer command) {
    Optional<Connection> connection = client.current();
    Optional<DeviceAddress> address = address();
    return connection.isPresent() && address.isPresent()
        && connection.get().command(PlayerMessage.of(address.get(), MessageType.COMMAND, subtype, command));
  }
}
