"""Services of simulation_interfaces 2.0, and the action FollowJointTrajectory, as types of Cyclone DDS (ros2_types.py)."""

from dataclasses import dataclass, field

from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import array, float64, int8, int32, sequence, uint8, uint16, uint64
from ros2_types import (
    Accel,
    Duration,
    Header,
    JointTrajectory,
    JointTrajectoryPoint,
    Pose,
    PoseStamped,
    Time,
    Transform,
    Twist,
    Vector3,
    message,
)


def of_simulation(name):
    return message("simulation_interfaces", name)


@dataclass
class Result(IdlStruct, **of_simulation("Result")):
    result: uint8 = 0
    error_message: str = ""


@dataclass
class Features(IdlStruct, **of_simulation("SimulatorFeatures")):
    features: sequence[uint16]
    spawn_formats: sequence[str]
    custom_info: str


@dataclass
class TagsFilter(IdlStruct, **of_simulation("TagsFilter")):
    tags: sequence[str] = field(default_factory=list)
    filter_mode: uint8 = 0


@dataclass
class Bounds(IdlStruct, **of_simulation("Bounds")):
    type: uint8 = 0
    points: sequence[Vector3] = field(default_factory=list)


@dataclass
class Category(IdlStruct, **of_simulation("EntityCategory")):
    category: uint8 = 0


@dataclass
class Filters(IdlStruct, **of_simulation("EntityFilters")):
    filter: str = ""
    categories: sequence[Category] = field(default_factory=list)
    tags: TagsFilter = field(default_factory=TagsFilter)
    bounds: Bounds = field(default_factory=Bounds)


@dataclass
class EntityState(IdlStruct, **of_simulation("EntityState")):
    header: Header = field(default_factory=Header)
    pose: Pose = field(default_factory=Pose)
    twist: Twist = field(default_factory=Twist)
    acceleration: Accel = field(default_factory=Accel)


@dataclass
class EntityInfo(IdlStruct, **of_simulation("EntityInfo")):
    category: Category
    description: str
    tags: sequence[str]


@dataclass
class Resource(IdlStruct, **of_simulation("Resource")):
    uri: str = ""
    resource_string: str = ""


@dataclass
class Spawnable(IdlStruct, **of_simulation("Spawnable")):
    entity_resource: Resource
    description: str
    spawn_bounds: Bounds


@dataclass
class World(IdlStruct, **of_simulation("WorldResource")):
    name: str
    world_resource: Resource
    description: str
    tags: sequence[str]


@dataclass
class NamedPose(IdlStruct, **of_simulation("NamedPose")):
    name: str
    description: str
    tags: sequence[str]
    pose: Pose


# Requests and answers: their names do not matter, their fields do (ros2_peer.py gives the names).

@dataclass
class Empty(IdlStruct):
    structure_needs_at_least_one_member: uint8 = 0


@dataclass
class Name(IdlStruct):
    entity: str = ""


@dataclass
class Filtered(IdlStruct):
    filters: Filters = field(default_factory=Filters)


@dataclass
class Sources(IdlStruct):
    sources: sequence[str] = field(default_factory=list)


@dataclass
class WorldSources(IdlStruct):
    sources: sequence[str] = field(default_factory=list)
    filter: TagsFilter = field(default_factory=TagsFilter)
    offline_only: bool = False
    continue_on_error: bool = False


@dataclass
class SetState(IdlStruct):
    entity: str
    state: EntityState
    set_pose: bool = True
    set_twist: bool = True
    set_acceleration: bool = False


@dataclass
class SetInfo(IdlStruct):
    entity: str
    info: EntityInfo


@dataclass
class ByTags(IdlStruct):
    tags: TagsFilter = field(default_factory=TagsFilter)


@dataclass
class NamedPoses(IdlStruct):
    result: Result
    poses: sequence[NamedPose]


@dataclass
class Spawn(IdlStruct):
    name: str
    allow_renaming: bool
    entity_resource: Resource
    entity_namespace: str
    initial_pose: PoseStamped


@dataclass
class SpawnRequest(Spawn, **of_simulation("SpawnEntity")):
    pass


@dataclass
class SpawnAll(IdlStruct):
    spawn_requests: sequence[SpawnRequest]


@dataclass
class Load(IdlStruct):
    world_resource: Resource
    fail_on_unsupported_element: bool = False
    ignore_missing_or_unsupported_assets: bool = False


@dataclass
class Scope(IdlStruct):
    scope: uint8 = 0


@dataclass
class Steps(IdlStruct):
    steps: uint64 = 0


@dataclass
class State(IdlStruct):
    state: uint8 = 0


@dataclass
class FeaturesAnswer(IdlStruct):
    simulator_features: Features


@dataclass
class ResultAnswer(IdlStruct):
    result: Result


@dataclass
class Names(IdlStruct):
    result: Result
    entities: sequence[str]


@dataclass
class NamesAndStates(IdlStruct):
    result: Result
    entities: sequence[str]
    states: sequence[EntityState]


@dataclass
class StateAnswer(IdlStruct):
    result: Result
    state: EntityState


@dataclass
class InfoAnswer(IdlStruct):
    result: Result
    info: EntityInfo


@dataclass
class BoundsAnswer(IdlStruct):
    result: Result
    bounds: Bounds


@dataclass
class Spawnables(IdlStruct):
    result: Result
    spawnables: sequence[Spawnable]


@dataclass
class Spawned(IdlStruct):
    result: Result
    entity_name: str


@dataclass
class SpawnResult(Spawned, **of_simulation("SpawnResult")):
    pass


@dataclass
class AllSpawned(IdlStruct):
    result: Result
    results: sequence[SpawnResult]


@dataclass
class RunState(IdlStruct):
    state: uint8
    result: Result


@dataclass
class WorldAnswer(IdlStruct):
    result: Result
    world: World


@dataclass
class Worlds(IdlStruct):
    result: Result
    worlds: sequence[World]


# service: type, request, answer
SERVICES = {
    "/get_simulator_features": ("GetSimulatorFeatures", Empty, FeaturesAnswer),
    "/get_entities": ("GetEntities", Filtered, Names),
    "/get_entities_states": ("GetEntitiesStates", Filtered, NamesAndStates),
    "/get_entity_state": ("GetEntityState", Name, StateAnswer),
    "/set_entity_state": ("SetEntityState", SetState, ResultAnswer),
    "/get_entity_info": ("GetEntityInfo", Name, InfoAnswer),
    "/get_entity_bounds": ("GetEntityBounds", Name, BoundsAnswer),
    "/set_entity_info": ("SetEntityInfo", SetInfo, ResultAnswer),
    "/get_named_poses": ("GetNamedPoses", ByTags, NamedPoses),
    "/get_named_pose_bounds": ("GetNamedPoseBounds", Name, BoundsAnswer),
    "/get_spawnables": ("GetSpawnables", Sources, Spawnables),
    "/spawn_entity": ("SpawnEntity", Spawn, Spawned),
    "/spawn_entities": ("SpawnEntities", SpawnAll, AllSpawned),
    "/delete_entity": ("DeleteEntity", Name, ResultAnswer),
    "/reset_simulation": ("ResetSimulation", Scope, ResultAnswer),
    "/step_simulation": ("StepSimulation", Steps, ResultAnswer),
    "/get_simulation_state": ("GetSimulationState", Empty, RunState),
    "/set_simulation_state": ("SetSimulationState", State, ResultAnswer),
    "/get_current_world": ("GetCurrentWorld", Empty, WorldAnswer),
    "/get_available_worlds": ("GetAvailableWorlds", WorldSources, Worlds),
    "/load_world": ("LoadWorld", Load, WorldAnswer),
    "/unload_world": ("UnloadWorld", Empty, ResultAnswer),
}

# ---- control_msgs/FollowJointTrajectory ----

FOLLOW = "control_msgs/action/FollowJointTrajectory"


@dataclass
class GoalId(IdlStruct, **message("unique_identifier_msgs", "UUID")):
    uuid: array[uint8, 16]


@dataclass
class GoalInfo(IdlStruct, **message("action_msgs", "GoalInfo")):
    goal_id: GoalId
    stamp: Time


@dataclass
class GoalStatus(IdlStruct, **message("action_msgs", "GoalStatus")):
    goal_info: GoalInfo
    status: int8


@dataclass
class GoalStatusArray(IdlStruct, **message("action_msgs", "GoalStatusArray")):
    status_list: sequence[GoalStatus]


@dataclass
class MultiPoint(IdlStruct, **message("trajectory_msgs", "MultiDOFJointTrajectoryPoint")):
    transforms: sequence[Transform] = field(default_factory=list)
    velocities: sequence[Twist] = field(default_factory=list)
    accelerations: sequence[Twist] = field(default_factory=list)
    time_from_start: Duration = field(default_factory=Duration)


@dataclass
class MultiTrajectory(IdlStruct, **message("trajectory_msgs", "MultiDOFJointTrajectory")):
    header: Header = field(default_factory=Header)
    joint_names: sequence[str] = field(default_factory=list)
    points: sequence[MultiPoint] = field(default_factory=list)


@dataclass
class Tolerance(IdlStruct, **message("control_msgs", "JointTolerance")):
    name: str
    position: float64
    velocity: float64
    acceleration: float64


@dataclass
class Goal(IdlStruct, **message("control_msgs", "FollowJointTrajectory_Goal", "action")):
    trajectory: JointTrajectory
    multi_dof_trajectory: MultiTrajectory = field(default_factory=MultiTrajectory)
    path_tolerance: sequence[Tolerance] = field(default_factory=list)
    component_path_tolerance: sequence[Tolerance] = field(default_factory=list)
    goal_tolerance: sequence[Tolerance] = field(default_factory=list)
    component_goal_tolerance: sequence[Tolerance] = field(default_factory=list)
    goal_time_tolerance: Duration = field(default_factory=Duration)


@dataclass
class SendGoal(IdlStruct):
    goal_id: GoalId
    goal: Goal


@dataclass
class GoalAnswer(IdlStruct):
    accepted: bool
    stamp: Time


@dataclass
class GetResult(IdlStruct):
    goal_id: GoalId


@dataclass
class FollowResult(IdlStruct, **message("control_msgs", "FollowJointTrajectory_Result", "action")):
    error_code: int32
    error_string: str


@dataclass
class ResultOfGoal(IdlStruct):
    status: int8
    result: FollowResult


@dataclass
class CancelGoal(IdlStruct):
    goal_info: GoalInfo


@dataclass
class CancelAnswer(IdlStruct):
    return_code: int8
    goals_canceling: sequence[GoalInfo]


@dataclass
class Feedback(IdlStruct, **message("control_msgs", "FollowJointTrajectory_Feedback", "action")):
    header: Header
    joint_names: sequence[str]
    desired: JointTrajectoryPoint
    actual: JointTrajectoryPoint
    error: JointTrajectoryPoint
    multi_dof_joint_names: sequence[str]
    multi_dof_desired: MultiPoint
    multi_dof_actual: MultiPoint
    multi_dof_error: MultiPoint


@dataclass
class FeedbackMessage(IdlStruct, **message("control_msgs", "FollowJointTrajectory_FeedbackMessage", "action")):
    goal_id: GoalId
    feedback: Feedback


# ---- simulation_interfaces/SimulateSteps ----

STEP = "simulation_interfaces/action/SimulateSteps"


@dataclass
class SendSteps(IdlStruct):
    goal_id: GoalId
    steps: uint64


@dataclass
class StepsResult(IdlStruct):
    status: int8
    result: Result


@dataclass
class StepsFeedback(IdlStruct, **message("simulation_interfaces", "SimulateSteps_FeedbackMessage", "action")):
    goal_id: GoalId
    completed_steps: uint64
    remaining_steps: uint64
