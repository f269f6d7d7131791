package org.robotui.uic.scene3d.internal.model;

import org.robotui.api.port.SourceId;

/** How sources are written: {@code base/scan} for the topic {@code /scan} of the robot interface {@code base}. */
public final class SourceName {
  private SourceName() {}

  /** The name of a source. */
  public static String of(SourceId source) {
    return source.component() + '/' + bare(source.port());
  }

  /** Whether a name means a source: with or without the robot interface. */
  public static boolean fits(String written, SourceId source) {
    String name = written.strip();
    return name.equals(of(source)) || name.equals(source.toString()) || bare(name).equals(bare(source.port()));
  }

  private static String bare(String port) {
    return port.startsWith("/") ? port.substring(1) : port;
  }
}
