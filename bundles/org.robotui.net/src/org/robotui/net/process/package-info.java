/**
 * Other processes of this machine: which of them still run ({@link org.robotui.net.process.RunningProcess}), and what
 * those of this user say ({@link org.robotui.net.process.SocketAnswer}).
 */
@org.osgi.annotation.versioning.Version("1.2.0")
package org.robotui.net.process;
