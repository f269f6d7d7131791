package org.robotui.ros.msgs;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class StandardServicesTest {
  /** The sums are those that the generated Python classes of the ROS packages carry. */
  @Test
  void compiledServicesHaveTheSumOfTheRealPackage() {
    assertEquals("09fb03525b03e7ea1fd3992bafd87e16", StandardServices.SET_BOOL.md5());
    assertEquals("d41d8cd98f00b204e9800998ecf8427e", StandardServices.EMPTY.md5());
    assertEquals("6cdd0a18e0aff5b0a3ca2326a89b54ff", StandardServices.GET_MAP.md5());
  }
}
