package org.robotui.guard.internal.client;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketAddress;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import org.robotui.guard.internal.wire.Wire;

/** A socket to a guard that looks like one to the robot: only connecting is different. */
final class GuardedSocket extends Socket {
  private static final int LONGEST = 60_000;
  /** The guard says itself that the time is over; that takes a moment. */
  private static final int MOMENT = 1000;

  private final SharedGuard guard;
  private volatile InetSocketAddress robot;

  GuardedSocket(SharedGuard guard) {
    this.guard = guard;
  }

  @Override
  public void connect(SocketAddress endpoint) throws IOException {
    connect(endpoint, 0);
  }

  @Override
  public void connect(SocketAddress endpoint, int timeout) throws IOException {
    if (!(endpoint instanceof InetSocketAddress address) || address.isUnresolved()) {
      throw new UnknownHostException(String.valueOf(endpoint));
    }
    int patience = timeout <= 0 ? LONGEST : Math.min(timeout, LONGEST);
    GuardProcess process = guard.running();
    super.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), process.port()), patience);
    int before = getSoTimeout();
    setSoTimeout(patience + MOMENT);
    getOutputStream().write(greeting(process.secrets().knock(), address, patience));
    reply(new DataInputStream(getInputStream()), process.secrets().answer());
    setSoTimeout(before);
    robot = address;
  }

  private static byte[] greeting(byte[] knock, InetSocketAddress address, int patience) throws IOException {
    ByteArrayOutputStream greeting = new ByteArrayOutputStream();
    DataOutputStream out = new DataOutputStream(greeting);
    byte[] bytes = address.getAddress().getAddress();
    out.write(knock);
    out.writeByte(bytes.length);
    out.write(bytes);
    out.writeShort(address.getPort());
    out.writeInt(patience);
    return greeting.toByteArray();
  }

  private static void reply(DataInputStream in, byte[] answer) throws IOException {
    try {
      byte[] said = new byte[answer.length];
      in.readFully(said);
      if (!MessageDigest.isEqual(said, answer)) {
        throw new ConnectException("who answered is not our guard");
      }
      if (in.readUnsignedByte() != Wire.DONE) {
        byte[] reason = new byte[in.readUnsignedShort()];
        in.readFully(reason);
        refuse(new String(reason, StandardCharsets.UTF_8));
      }
    } catch (EOFException e) {
      ConnectException lost = new ConnectException("the guard closed the connection");
      lost.initCause(e);
      throw lost;
    }
  }

  private static void refuse(String reason) throws IOException {
    if (reason.equals("timed out")) {
      throw new SocketTimeoutException(reason);
    }
    throw new ConnectException(reason);
  }

  @Override
  public SocketAddress getRemoteSocketAddress() {
    return robot == null ? super.getRemoteSocketAddress() : robot;
  }

  @Override
  public InetAddress getInetAddress() {
    return robot == null ? super.getInetAddress() : robot.getAddress();
  }

  @Override
  public int getPort() {
    return robot == null ? super.getPort() : robot.getPort();
  }
}
