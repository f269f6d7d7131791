package org.robotui.gazebo.internal;

import java.util.regex.Pattern;

/** Addresses that peers name. Only those of TCP that nobody has to be asked for are connected to. */
final class PeerAddress {
  private static final Pattern NUMERIC = Pattern.compile("tcp://[0-9]{1,3}(\\.[0-9]{1,3}){3}:[0-9]{1,5}");

  private PeerAddress() {}

  static boolean isGood(String address) {
    return NUMERIC.matcher(address).matches()
        && Integer.parseInt(address.substring(address.lastIndexOf(':') + 1)) < 1 << Short.SIZE;
  }
}
