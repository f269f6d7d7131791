package org.robotui.smartsoft.server;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.message.CdrReader;
import org.robotui.message.MessageException;
import org.robotui.smartsoft.client.EventMode;
import org.robotui.smartsoft.internal.PatternData;
import org.robotui.smartsoft.internal.ServedClient;
import org.robotui.smartsoft.internal.ServiceDoor;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.wire.SmartCommand;
import org.robotui.smartsoft.wire.SmartFrame;

/**
 * A server of event: each new state is compared with the parameter of each activation.
 *
 * @param <S> the state
 */
public final class EventServer<S> implements PatternServer {

  private static final int MOST_ACTIVATIONS = 256;

  private final Test<S> test;
  private final ServiceDoor door;
  private final Map<ServedClient, Map<Long, Activation>> activations = new ConcurrentHashMap<>();

  private record Activation(EventMode mode, ByteBuffer parameter) {}

  /**
   * Decides whether an event happens.
   *
   * @param <S> the state
   */
  @FunctionalInterface
  public interface Test<S> {

    /**
     * Compares a state with what a client has asked for.
     *
     * @param parameter of an activation, in the order of its bytes
     * @param state the new one
     * @return what happens; empty where nothing does
     * @throws MessageException where the parameter is none of this service, which ends the activation
     */
    Optional<Happening> event(ByteBuffer parameter, S state) throws MessageException;
  }

  /**
   * An event.
   *
   * @param event its bytes, little endian
   * @param parameter that of the activation from now on, little endian: where it has a state that its client knows,
   * servers put the one there that was told
   */
  public record Happening(ByteBuffer event, ByteBuffer parameter) {}

  /**
   * Listens at once.
   *
   * @param options where
   * @param test decides
   * @throws IOException where the port cannot be had
   */
  public EventServer(SmartServerOptions options, Test<S> test) throws IOException {
    this.test = test;
    this.door = new ServiceDoor(options, new FromClients());
  }

  @Override
  public ServiceAddress address() {
    return door.address();
  }

  /**
   * How many activations there are.
   *
   * @return of all clients
   */
  public int activations() {
    return activations.values().stream().mapToInt(Map::size).sum();
  }

  /**
   * Compares a new state with all activations, and tells whoever is concerned.
   *
   * @param state the new one
   */
  public void put(S state) {
    activations.forEach((client, all) -> all.forEach((number, activation) -> {
      Optional<Activation> left = fire(client, number, activation, state);
      if (left.isEmpty()) {
        all.remove(number, activation);
      } else {
        all.replace(number, activation, left.get());
      }
    }));
  }

  /** What is left of an activation; empty where it has come to its end. */
  private Optional<Activation> fire(ServedClient client, long number, Activation activation, S state) {
    ByteBuffer parameter = activation.parameter().duplicate().order(activation.parameter().order());
    try {
      Optional<Happening> happens = test.event(parameter, state);
      if (happens.isEmpty()) {
        return Optional.of(activation);
      }
      client.send(SmartFrame.of(SmartCommand.EVENT, PatternData.of().i64(number).end(), happens.get().event()));
      return activation.mode() == EventMode.SINGLE ? Optional.empty()
          : Optional.of(new Activation(activation.mode(), happens.get().parameter()));
    } catch (MessageException e) {
      return Optional.empty();
    }
  }

  private final class FromClients implements ServiceDoor.Pattern {
    @Override
    public void said(SmartCommand command, SmartFrame frame, ServedClient client)
        throws IOException, MessageException {
      CdrReader said = frame.reader();
      switch (command) {
        case ACTIVATE -> {
          EventMode mode = said.int32("mode") == 0 ? EventMode.SINGLE : EventMode.CONTINUOUS;
          long number = said.int64("activation");
          Map<Long, Activation> all = activations.computeIfAbsent(client, each -> new ConcurrentHashMap<>());
          if (all.size() >= MOST_ACTIVATIONS) {
            throw new IOException("a client has activated " + MOST_ACTIVATIONS + " events already");
          }
          all.put(number, new Activation(mode, frame.object()));
          client.send(SmartFrame.of(SmartCommand.ACK_ACTIVATE, PatternData.of().i64(number).end()));
        }
        case DEACTIVATE -> {
          Map<Long, Activation> all = activations.get(client);
          if (all != null) {
            all.remove(said.int64("activation"));
          }
        }
        default -> {}
      }
    }

    @Override
    public void left(ServedClient client) {
      activations.remove(client);
    }
  }

  @Override
  public void close() {
    door.close();
  }
}
