package org.robotui.smartsoft.naming;

import org.robotui.net.socket.HostPort;
import org.robotui.smartsoft.wire.SmartSoftException;

/**
 * Where a service is, written as {@code address:port#identifier}.
 *
 * @param at where it listens
 * @param identifier of the service, which its server compares
 */
public record ServiceAddress(HostPort at, String identifier) {

  /**
   * Reads an address.
   *
   * @param written as a naming service gives it
   * @return the address
   * @throws SmartSoftException where it is none
   */
  public static ServiceAddress parse(String written) throws SmartSoftException {
    int hash = written.indexOf('#');
    int colon = written.lastIndexOf(':', hash);
    try {
      return new ServiceAddress(
          new HostPort(written.substring(0, colon), Integer.parseInt(written.substring(colon + 1, hash))),
          written.substring(hash + 1));
    } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
      SmartSoftException refused = new SmartSoftException("'" + written + "' is no address of a service");
      refused.initCause(e);
      throw refused;
    }
  }

  @Override
  public String toString() {
    return at + "#" + identifier;
  }
}
