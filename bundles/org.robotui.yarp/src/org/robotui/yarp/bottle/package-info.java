/**
 * Bottles, which YARP's ports send: lists of values, as bytes and as text. Lengths that lie are found before anything
 * is allocated for them. All is immutable and safe for all threads. Source: the code and recorded sessions of YARP
 * 3.9.1.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.yarp.bottle;
