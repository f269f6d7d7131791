package org.robotui.rfic.smartsoft.internal.feed;

import java.io.IOException;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.Offer;
import org.robotui.api.session.BaseDriving;
import org.robotui.data.command.VelocityCommand;
import org.robotui.message.MessageException;
import org.robotui.rfic.smartsoft.internal.convert.SmartPlaces;
import org.robotui.smartsoft.client.SendClient;
import org.robotui.smartsoft.naming.NamedService;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.naming.SmartPattern;
import org.robotui.smartsoft.object.CommType;

/**
 * Services that are sent velocities, as commands. They are connected to as soon as they are known, so that a command
 * waits for nothing. The first is {@code velocity}, others are called after their services.
 */
public final class SmartCommanding implements AutoCloseable {
  /** What services that drive are sent. */
  public static final String VELOCITY = "CommBasicObjects::CommNavigationVelocity";
  private static final String PORT = "velocity";
  private static final long AGAIN_NANOS = Duration.ofSeconds(1).toNanos();

  private final SmartShared shared;
  private final SmartServices services;
  private final Runnable halting;
  private final CommType type;
  private final Map<String, Drive> drives = new HashMap<>(); // guarded by this
  private boolean closed; // guarded by this

  /** What is done beside when the robot is stopped does not block. */
  public SmartCommanding(SmartShared shared, SmartServices services, Runnable halting) {
    this.halting = halting;
    this.shared = shared;
    this.services = services;
    this.type = shared.types().get(VELOCITY);
  }

  /** Connects to services that drive; blocks. */
  public void look() {
    Map<String, NamedService> found = services.of(SmartPattern.SEND, VELOCITY);
    found.forEach((path, service) -> drive(path).ifPresent(drive -> drive.connect(service.address())));
  }

  private synchronized Optional<Drive> drive(String path) {
    if (closed) {
      return Optional.empty();
    }
    String port = drives.isEmpty() ? PORT : path;
    return Optional.of(drives.computeIfAbsent(path, each -> new Drive(each, port)));
  }

  /** Whether a service that drives is linked, whatever the naming service does. */
  public synchronized boolean isAlive() {
    return drives.values().stream().anyMatch(Drive::isAlive);
  }

  private final class Drive implements BaseDriving.Base {
    private final String path;
    private final BaseDriving driving;
    private final Offer offer;
    private volatile Optional<SendClient> client = Optional.empty();
    private Optional<ServiceAddress> connectedTo = Optional.empty(); // only on the thread that follows
    private long triedAt = System.nanoTime() - AGAIN_NANOS; // only on the thread that follows
    private boolean ended; // guarded by this

    Drive(String path, String port) {
      this.path = path;
      this.driving = new BaseDriving(shared.settings().peer(), shared.pulse(), this);
      this.offer = shared.context().offers().command(
          new CommandPort<>(port, VelocityCommand.class, Arity.MANY, "velocity of the base, by " + path), driving);
    }

    boolean isAlive() {
      return client.isPresent() && client.get().over().isEmpty();
    }

    void connect(ServiceAddress address) {
      boolean fits = isAlive() && connectedTo.equals(Optional.of(address));
      if (fits || System.nanoTime() - triedAt < AGAIN_NANOS) {
        return;
      }
      triedAt = System.nanoTime();
      client.ifPresent(SendClient::close);
      client = Optional.empty();
      try {
        keep(SendClient.connect(address, shared.links()));
        connectedTo = Optional.of(address);
      } catch (IOException e) {
        connectedTo = Optional.empty(); // a command says so, and it is tried again
      }
    }

    private synchronized void keep(SendClient made) {
      if (ended) {
        made.close();
      } else {
        client = Optional.of(made);
      }
    }

    @Override
    public Sent drive(VelocityCommand command) {
      try {
        boolean sent = client.isPresent() && client.get().replace(type.bytes(SmartPlaces.velocity(command)));
        return sent ? new Sent.Out()
            : new Sent.Refused(path + " cannot be reached; it is tried again every second");
      } catch (MessageException e) {
        return new Sent.Refused(path + " does not take this: " + e.getMessage());
      }
    }

    /** Goals that we sent would let it drive on. */
    @Override
    public Sent halt(VelocityCommand zero) {
      halting.run();
      return drive(zero);
    }

    synchronized void finish() {
      driving.close();
      ended = true;
      client.ifPresent(SendClient::finish);
    }

    void close() {
      offer.close();
      client.ifPresent(SendClient::close);
    }
  }

  @Override
  public synchronized void close() {
    closed = true;
    drives.values().forEach(Drive::finish);
    drives.values().forEach(Drive::close);
  }
}
