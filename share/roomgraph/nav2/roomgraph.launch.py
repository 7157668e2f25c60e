"""Loads into nav2 what `roomgraph extract --format geojson,keepout,speed` wrote of a map:

    ros2 launch roomgraph.launch.py map:=office.yaml results:=roomgraph-extract

starts the map, the route server on its graph, and the servers of both masks. The frame is `map`.
"""
import os

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

HERE = os.path.dirname(os.path.abspath(__file__))


def nodes(context):
    map_file = os.path.abspath(LaunchConfiguration('map').perform(context))
    results = os.path.abspath(LaunchConfiguration('results').perform(context))
    stem = os.path.join(results, os.path.splitext(os.path.basename(map_file))[0])
    masks = os.path.join(HERE, 'masks.yaml')
    servers = [
        ('nav2_map_server', 'map_server', 'map_server', [{'yaml_filename': map_file}]),
        ('nav2_route', 'route_server', 'route_server',
         [os.path.join(HERE, 'route_server.yaml'), {'graph_filepath': stem + '.geojson'}])]
    for kind in ('keepout', 'speed'):
        servers += [
            ('nav2_map_server', 'map_server', kind + '_mask_server',
             [masks, {'yaml_filename': stem + '.' + kind + '.yaml'}]),
            ('nav2_map_server', 'costmap_filter_info_server', kind + '_info_server', [masks])]
    started = [Node(package=package, executable=executable, name=name, output='screen',
                    parameters=parameters)
               for package, executable, name, parameters in servers]
    manager = Node(package='nav2_lifecycle_manager', executable='lifecycle_manager',
                   name='lifecycle_manager_roomgraph', output='screen',
                   parameters=[{'autostart': True, 'node_names': [name for _, _, name, _ in servers]}])
    return started + [manager]


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('map', description='The yaml of the ROS map that was extracted.'),
        DeclareLaunchArgument('results', default_value='roomgraph-extract',
                              description='The folder that the results are in.'),
        OpaqueFunction(function=nodes)])
