package org.robotui.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import org.junit.jupiter.api.Test;
import org.robotui.message.ros.geometry_msgs.Vector3;

class HiddenTest {
  /** Each bundle has a loader of its own: so has this one, with a record of its own. */
  private static final class Bundle extends ClassLoader {
    Bundle() {
      super(HiddenTest.class.getClassLoader());
    }

    @SuppressWarnings("unchecked") // a record
    Class<Record> own(Class<? extends Record> record) throws IOException {
      String name = record.getName();
      try (InputStream in = record.getResourceAsStream(name.substring(name.lastIndexOf('.') + 1) + ".class")) {
        byte[] code = in.readAllBytes();
        return (Class<Record>) defineClass(name, code, 0, code.length);
      }
    }
  }

  /** Inside OSGi this failed for records that another bundle than this one brings. */
  @Test
  void recordsOfAnotherBundleAreBound() throws Exception {
    Class<Record> own = new Bundle().own(Vector3.class);
    assertNotSame(Vector3.class, own);
    ByteBuffer bytes = RecordBinding.shipped(Vector3.class, Generation.ROS1).encode(new Vector3(1, 2, 3));

    RecordBinding<Record> binding = RecordBinding.shipped(own, Generation.ROS1);
    Record value = binding.decode(bytes.duplicate().order(bytes.order()));

    assertEquals(own, value.getClass());
    assertEquals(new Vector3(1, 2, 3).toString(), value.toString());
    assertEquals(bytes, binding.encode(value));
  }
}
