package org.robotui.guard;

import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;

/**
 * A program that is stopped and killed: it takes what comes through a guard, and leaves a farewell. Arguments: the
 * ports of the robot and of who hears farewells.
 */
final class Workbench {
  private Workbench() {}

  public static void main(String[] arguments) throws Exception {
    Guard guard = new Guards().open();
    guard.farewell(at(arguments[1]), "farewell".getBytes(StandardCharsets.UTF_8));
    System.out.println(guard.state().pid());
    while (true) {
      try (Socket socket = guard.sockets().createSocket()) {
        socket.connect(at(arguments[0]), 5000);
        socket.getInputStream().transferTo(OutputStream.nullOutputStream());
      } catch (java.io.IOException e) {
        Thread.sleep(100);
      }
    }
  }

  private static InetSocketAddress at(String port) {
    return new InetSocketAddress(InetAddress.getLoopbackAddress(), Integer.parseInt(port));
  }
}
