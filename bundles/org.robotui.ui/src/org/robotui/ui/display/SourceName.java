package org.robotui.ui.display;

import java.util.List;
import org.robotui.api.port.SourceId;

/** How sources are written: {@code base/scan} for the topic {@code /scan} of the robot interface {@code base}. */
public final class SourceName {
  private SourceName() {}

  /**
   * The name of a source.
   *
   * @param source a stream of a robot interface
   * @return the name, for example {@code base/scan}
   */
  public static String of(SourceId source) {
    return source.component() + '/' + bare(source.port());
  }

  /**
   * A short name among others: without the folders that all of them begin with, as lists have no room for what tells
   * nothing.
   *
   * @param source a stream
   * @param all the streams that it is to be told from
   * @return the name
   */
  public static String among(SourceId source, List<SourceId> all) {
    String name = of(source);
    int from = 0;
    for (int slash = name.indexOf('/'); slash >= 0; slash = name.indexOf('/', from)) {
      String folders = name.substring(0, slash + 1);
      if (!all.stream().allMatch(other -> of(other).startsWith(folders))) {
        break;
      }
      from = slash + 1;
    }
    return name.substring(from);
  }

  /**
   * Whether a name means a source: with or without the robot interface.
   *
   * @param written the name
   * @param source the source
   * @return true where it does
   */
  public static boolean fits(String written, SourceId source) {
    String name = written.strip();
    return name.equals(of(source)) || name.equals(source.toString()) || bare(name).equals(bare(source.port()));
  }

  private static String bare(String port) {
    return port.startsWith("/") ? port.substring(1) : port;
  }
}
