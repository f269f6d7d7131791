package org.robotui.ros.tests;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;

/** The ROS packages these tests need as peers: the one place that decides whether they can run. */
final class RosInstallation {

  private static final String PYTHON_PARTS =
      "import rospy, rosgraph, rostopic, rosservice, rosparam, rosnode, rosbag, roslaunch,"
          + " std_msgs.msg, std_srvs.srv";

  private RosInstallation() {}

  /** Skips the test, with the packages to install, if they are missing. */
  static void assumeThere() {
    Assumptions.assumeTrue(succeeds("/usr/bin/python3", "-c", PYTHON_PARTS),
        "ROS 1 is not installed: needs the Debian packages python3-roslaunch python3-rostopic python3-rosbag"
            + " python3-rosservice python3-rosnode python3-rosparam python3-std-srvs");
    Assumptions.assumeTrue(
        succeeds("g++", "--version") && succeeds("pkg-config", "--exists", "roscpp", "std_msgs", "std_srvs"),
        "roscpp is not installed: needs g++ and the Debian packages libroscpp-dev libstd-msgs-dev libstd-srvs-dev");
  }

  /** Skips the test if Python packages beyond the usual ones are missing. */
  static void assumePython(String imports, String debianPackages) {
    Assumptions.assumeTrue(succeeds("/usr/bin/python3", "-c", "import " + imports),
        "not installed: the Debian packages " + debianPackages);
  }

  private static boolean succeeds(String... command) {
    try {
      Process process = new ProcessBuilder(List.of(command)).redirectErrorStream(true)
          .redirectOutput(ProcessBuilder.Redirect.DISCARD).start();
      if (process.waitFor(30, TimeUnit.SECONDS)) {
        return process.exitValue() == 0;
      }
      process.destroyForcibly();
      return false;
    } catch (IOException e) {
      return false;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }
}
