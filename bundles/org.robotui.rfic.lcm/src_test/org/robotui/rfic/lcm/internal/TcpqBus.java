package org.robotui.rfic.lcm.internal;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import org.robotui.lcm.tcpq.TcpqServer;
import org.robotui.lcm.tcpq.TcpqServerOptions;
import org.robotui.testkit.rfic.Capability;
import org.robotui.testkit.rfic.Gate;
import org.robotui.testkit.rfic.Peer;

/** A server of messages, behind a gate. What the gate holds is carried later, so nobody needs to know that it does. */
final class TcpqBus implements LcmBus {
  private final Gate gate;
  private Optional<TcpqServer> server = Optional.empty();

  TcpqBus() throws IOException {
    gate = new Gate();
  }

  @Override
  public Map<Capability, String> lacks() {
    return Map.of();
  }

  @Override
  public String url() {
    return url(gate.port());
  }

  private static String url(int port) {
    return "tcpq://127.0.0.1:" + port;
  }

  @Override
  public String open() throws IOException {
    TcpqServer opened = TcpqServer.open(TcpqServerOptions.loopback(Peer.THREADS, 0));
    server = Optional.of(opened);
    gate.open(opened.address().getPort());
    return url(opened.address().getPort());
  }

  @Override
  public void shut() {
    gate.shut();
    server.ifPresent(TcpqServer::close);
    server = Optional.empty();
  }

  @Override
  public void hold() {
    gate.hold();
  }

  @Override
  public void goOn() {
    gate.goOn();
  }

  @Override
  public boolean holds() {
    return false;
  }

  @Override
  public void inject(byte[] bytes) throws IOException {
    gate.inject(bytes);
  }

  @Override
  public int links() {
    return gate.links();
  }

  @Override
  public void close() {
    shut();
    gate.close();
  }
}
