package org.robotui.rtps.internal.wire;

/** The numbers of parameters that this library reads or writes. */
public final class ParameterId {

  public static final int LEASE = 0x0002;
  public static final int TOPIC_NAME = 0x0005;
  public static final int TYPE_NAME = 0x0007;
  public static final int DOMAIN_ID = 0x000f;
  public static final int PROTOCOL_VERSION = 0x0015;
  public static final int VENDOR_ID = 0x0016;
  public static final int RELIABILITY = 0x001a;
  public static final int LIVELINESS = 0x001b;
  public static final int DURABILITY = 0x001d;
  public static final int OWNERSHIP = 0x001f;
  public static final int DEADLINE = 0x0023;
  public static final int PARTITION = 0x0029;
  public static final int LIFESPAN = 0x002b;
  public static final int USER_DATA = 0x002c;
  public static final int UNICAST_LOCATOR = 0x002f;
  public static final int MULTICAST_LOCATOR = 0x0030;
  public static final int DEFAULT_UNICAST_LOCATOR = 0x0031;
  public static final int METATRAFFIC_UNICAST_LOCATOR = 0x0032;
  public static final int METATRAFFIC_MULTICAST_LOCATOR = 0x0033;
  public static final int HISTORY = 0x0040;
  public static final int EXPECTS_INLINE_QOS = 0x0043;
  /** The first form of {@link #BUILTIN_ENDPOINTS}. */
  public static final int BUILTIN_ENDPOINTS_OLD = 0x0044;
  public static final int DEFAULT_MULTICAST_LOCATOR = 0x0048;
  public static final int PARTICIPANT_GUID = 0x0050;
  public static final int BUILTIN_ENDPOINTS = 0x0058;
  public static final int ENDPOINT_GUID = 0x005a;
  public static final int ENTITY_NAME = 0x0062;
  public static final int KEY_HASH = 0x0070;
  public static final int STATUS_INFO = 0x0071;
  public static final int DATA_REPRESENTATION = 0x0073;
  public static final int RELATED_SAMPLE = 0x0083;
  /** As Fast DDS had it before it was standard. */
  public static final int RELATED_SAMPLE_OLD = 0x800f;
  /** Without the flag that asks to understand it, which it always has: 0x4014 on the wire. */
  public static final int DOMAIN_TAG = 0x0014;

  private ParameterId() {}
}
