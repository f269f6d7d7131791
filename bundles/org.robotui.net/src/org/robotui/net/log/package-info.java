/**
 * What a library may write into a log about its peers, so that none of them can fill a disk or forge a line: bounded
 * text ({@link org.robotui.net.log.PeerText}) and ever fewer lines about like events
 * ({@link org.robotui.net.log.LogThrottle}). Safe for all threads; nothing here blocks.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.net.log;
