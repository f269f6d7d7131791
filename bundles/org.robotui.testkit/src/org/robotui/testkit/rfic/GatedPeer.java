package org.robotui.testkit.rfic;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.data.Data;

/**
 * A robot that is reached over TCP through one gate, by which it hangs and its links are counted. It lacks nothing
 * unless it says so.
 */
public abstract class GatedPeer implements Peer {
  private final Gate gate;
  private final List<Data> heard = new CopyOnWriteArrayList<>();

  /** Listens at its gate; the robot is away. */
  protected GatedPeer() {
    try {
      gate = new Gate();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * What lies before the robot. Whoever starts it opens the gate to its port, whoever kills it shuts it first.
   *
   * @return the gate
   */
  protected final Gate gate() {
    return gate;
  }

  /**
   * The robot was commanded.
   *
   * @param command what it heard
   */
  protected final void hears(Data command) {
    heard.add(command);
  }

  /**
   * Where it is reached, also while it is away.
   *
   * @return a port on loopback
   */
  public final int port() {
    return gate.port();
  }

  /** Shuts the gate, and ends whoever listens behind it. */
  @Override
  public abstract void kill();

  @Override
  public Map<Capability, String> lacks() {
    return Map.of();
  }

  @Override
  public void hang() {
    gate.hold();
  }

  @Override
  public void goOn() {
    gate.goOn();
  }

  @Override
  public List<Data> heard() {
    return List.copyOf(heard);
  }

  @Override
  public int links() {
    return gate.links();
  }

  @Override
  public void close() {
    kill();
    gate.close();
  }
}
